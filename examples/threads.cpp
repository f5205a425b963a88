// Lends threads to the library, which starts none itself, and follows the elements while they are decided.
//
//   threads MESH
#include <bezcert/bezcert.hpp>

#include <exception>
#include <iostream>
#include <mutex>
#include <thread>
#include <vector>

namespace {

// The simplest executor: one thread a work. A program with a pool of threads would use that.
class StdThreads : public bezcert::Executor {
 public:
  std::size_t threads() const override { return std::max(1U, std::thread::hardware_concurrency()); }

  void run(std::size_t count, const std::function<void(std::size_t)>& work) override {
    std::exception_ptr error;
    std::mutex mutex;
    std::size_t next = 0;
    const auto loop = [&] {
      for (;;) {
        std::size_t mine = 0;
        {
          const std::lock_guard lock(mutex);
          if (next >= count) return;
          mine = next++;
        }
        try {
          work(mine);
        } catch (...) {
          const std::lock_guard lock(mutex);
          error = std::current_exception();
        }
      }
    };
    std::vector<std::thread> running;
    for (std::size_t i = 1; i < std::min(threads(), count); ++i) running.emplace_back(loop);
    loop();
    for (std::thread& thread : running) thread.join();
    if (error) std::rethrow_exception(error);
  }
};

}  // namespace

int main(int argc, char** argv) {
  using namespace bezcert;
  if (argc != 2) {
    std::cerr << "usage: threads MESH\n";
    return 2;
  }
  try {
    StdThreads threads;
    const Mesh mesh = read_mesh_file(argv[1]);
    CheckOptions options;
    options.executor = &threads;
    // In mesh order, whatever the threads do.
    EachElement bad_ones([&](std::size_t i, const CheckedElement& checked) {
      if (checked.decision.verdict == ElementVerdict::injective) return;
      std::cout << "element " << mesh.origin().number(i) << ": " << describe(checked.decision) << '\n';
    });
    const MeshReport report = check_mesh(mesh, options, bad_ones);
    std::cout << report.elements.counts.elements << " elements, mesh: " << name(report.mesh.verdict) << '\n';
    return report.outcome() == Outcome::certified ? 0 : 1;
  } catch (const InputError& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
