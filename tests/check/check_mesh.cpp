// One call checks a mesh: parts add up to the whole, observers see every element in order, threads change
// nothing, and outcomes are what docs/report.md says.
#include "bezcert/check/check_mesh.hpp"

#include "bezcert/certificate/certificate.hpp"
#include "bezcert/io/file.hpp"
#include "bezcert/io/mesh/read.hpp"
#include "bezcert/mesh/mesh_builder.hpp"
#include "bezcert/report/report.hpp"

#include <catch2/catch.hpp>

#include <sstream>
#include <stdexcept>
#include <thread>

using namespace bezcert;

namespace {

// n by n unit squares; those whose place is a multiple of `reversed` are numbered clockwise.
Mesh squares(std::int64_t n, std::size_t reversed = 0) {
  MeshBuilder builder;
  for (std::int64_t r = 0; r <= n; ++r) {
    for (std::int64_t c = 0; c <= n; ++c) builder.add_node({static_cast<double>(c), static_cast<double>(r)});
  }
  std::size_t place = 0;
  for (std::int64_t r = 0; r < n; ++r) {
    for (std::int64_t c = 0; c < n; ++c) {
      const std::int64_t a = r * (n + 1) + c, d = a + n + 1;
      const bool turned = reversed > 0 && place++ % reversed == 0;
      if (turned) {
        builder.add_element(Shape::square(1, 1), Basis::lagrange, {a, d, a + 1, d + 1});
      } else {
        builder.add_element(Shape::square(1, 1), Basis::lagrange, {a, a + 1, d, d + 1});
      }
    }
  }
  return std::move(builder).build();
}

class StdThreads : public Executor {
 public:
  std::size_t threads() const override { return 3; }
  void run(std::size_t count, const std::function<void(std::size_t)>& work) override {
    std::vector<std::exception_ptr> errors(count);
    std::vector<std::thread> running;
    for (std::size_t i = 0; i < count; ++i) {
      running.emplace_back([&, i] {
        try {
          work(i);
        } catch (...) {
          errors[i] = std::current_exception();
        }
      });
    }
    for (std::thread& thread : running) thread.join();
    for (const std::exception_ptr& error : errors) {
      if (error) std::rethrow_exception(error);
    }
  }
};

void check_same(const MeshReport& a, const MeshReport& b) {
  CHECK(a.outcome() == b.outcome());
  CHECK(a.mesh.verdict == b.mesh.verdict);
  CHECK(a.mesh.components == b.mesh.components);
  CHECK(a.mesh.obstacles.all().size() == b.mesh.obstacles.all().size());
  CHECK(a.elements.states == b.elements.states);
  CHECK(a.elements.counts.by_verdict == b.elements.counts.by_verdict);
  CHECK(a.elements.counts.findings == b.elements.counts.findings);
  REQUIRE(a.elements.counts.by_criterion.size() == b.elements.counts.by_criterion.size());
  for (std::size_t i = 0; i < a.elements.counts.by_criterion.size(); ++i) {
    CHECK(a.elements.counts.by_criterion[i].by_status == b.elements.counts.by_criterion[i].by_status);
    CHECK(a.elements.counts.by_criterion[i].strength_gaps == b.elements.counts.by_criterion[i].strength_gaps);
  }
  REQUIRE(a.elements.bad.size() == b.elements.bad.size());
  for (std::size_t i = 0; i < a.elements.bad.size(); ++i) {
    CHECK(a.elements.bad[i].element == b.elements.bad[i].element);
    CHECK(a.elements.bad[i].decision.verdict == b.elements.bad[i].decision.verdict);
  }
}

}  // namespace

TEST_CASE("a mesh is checked with one call") {
  const MeshReport fine = check_mesh(squares(3));
  CHECK(fine.outcome() == Outcome::certified);
  CHECK(fine.elements.counts.elements == 9);
  CHECK(fine.elements.counts.count(ElementVerdict::injective) == 9);
  CHECK(fine.elements.bad.empty());
  REQUIRE(fine.mesh.area);
  CHECK(fine.mesh.area->lower == 9);
  CHECK_FALSE(fine.domain);

  // Places 0, 2, 4, 6, 8 are clockwise.
  const MeshReport turned = check_mesh(squares(3, 2));
  CHECK(turned.outcome() == Outcome::invalid);
  CHECK(turned.elements.counts.count(ElementVerdict::reversed) == 5);
  REQUIRE(turned.elements.bad.size() == 5);
  CHECK(turned.elements.bad[1].element == 2);
  CHECK(turned.mesh.verdict == MeshVerdict::invalid_element);
}

TEST_CASE("bad elements are counted all and kept some") {
  const MeshReport report = check_mesh(squares(7, 1));
  CHECK(report.elements.counts.count(ElementVerdict::reversed) == 49);
  REQUIRE(report.elements.bad.size() == ElementsReport::kept);
  for (std::size_t i = 0; i < ElementsReport::kept; ++i) CHECK(report.elements.bad[i].element == i);
}

TEST_CASE("parts of a mesh add up to the whole") {
  const std::string path = std::string(BEZCERT_SOURCE_DIR) + "/corpus/meshes/crescent_p3_41a.msh";
  CheckOptions options;
  options.criteria = all_criteria();
  CheckObserver nobody;
  for (const Mesh& mesh : {read_mesh(path, read_file(path)), squares(20, 3)}) {
    const MeshReport whole = check_mesh(mesh, options);
    const std::size_t count = mesh.elements().size();
    for (const std::size_t parts : {1, 2, 3, 7}) {
      ElementsReport sum = check_elements(mesh, 0, 0, options, nobody);
      for (std::size_t k = 0; k < parts; ++k) {
        sum.append(check_elements(mesh, k * count / parts, (k + 1) * count / parts, options, nobody));
      }
      check_same(conclude(mesh, std::move(sum), options), whole);
    }
    // What does not fit is refused.
    ElementsReport first = check_elements(mesh, 0, 1, options, nobody);
    CHECK_THROWS_AS(first.append(check_elements(mesh, 2, 3, options, nobody)), std::invalid_argument);
    CHECK_THROWS_AS(first.append(check_elements(mesh, 1, 2, {}, nobody)), std::invalid_argument);
    CHECK_THROWS_AS(conclude(mesh, first, options), std::invalid_argument);
    CHECK_THROWS_AS(check_elements(mesh, 0, count + 1, options, nobody), std::invalid_argument);
    CHECK_THROWS_AS(check_elements(mesh, 2, 1, options, nobody), std::invalid_argument);
  }
}

TEST_CASE("threads and filters change nothing, and observers see every element in mesh order") {
  const Mesh mesh = squares(70, 11);  // 4900 elements: enough for threads
  StdThreads threads;
  CheckOptions options;
  options.criteria = all_criteria();
  const MeshReport plain = check_mesh(mesh, options);
  for (const bool exact : {false, true}) {
    for (Executor* executor : {static_cast<Executor*>(nullptr), static_cast<Executor*>(&threads)}) {
      options.executor = executor;
      options.filter = exact ? Filter::off : Filter::on;
      std::size_t next = 0, reversed = 0;
      EachElement each([&](std::size_t i, const CheckedElement& checked) {
        CHECK(i == next++);
        CHECK(checked.criteria.size() == options.criteria.size());
        if (checked.decision.verdict == ElementVerdict::reversed) ++reversed;
      });
      check_same(check_mesh(mesh, options, each), plain);
      CHECK(next == 4900);
      CHECK(reversed == 446);  // ceil(4900 / 11)
    }
  }
}

TEST_CASE("several observers are called in their order, and what one throws comes through") {
  struct Noting : CheckObserver {
    Noting(std::string& log, char name) : log_(log), name_(name) {}
    void begin(const Mesh&) override { log_ += name_; }
    void end(const Mesh&, const MeshReport& report) override {
      log_ += report.outcome() == Outcome::certified ? name_ : '!';
    }
    std::string& log_;
    char name_;
  };
  std::string log;
  Noting a(log, 'a'), b(log, 'b');
  std::size_t seen = 0;
  EachElement each([&](std::size_t, const CheckedElement&) { ++seen; });
  Observers both;
  both.add(a);
  both.add(each);
  both.add(b);
  check_mesh(squares(2), {}, both);
  CHECK(log == "abab");
  CHECK(seen == 4);

  StdThreads threads;
  CheckOptions options;
  options.executor = &threads;
  EachElement stops([](std::size_t i, const CheckedElement&) {
    if (i == 2000) throw std::runtime_error("stop");
  });
  CHECK_THROWS_AS(check_mesh(squares(70), options, stops), std::runtime_error);
}

TEST_CASE("outcomes, from the best to the worst") {
  MeshReport report;
  report.mesh.verdict = MeshVerdict::embedding;
  CHECK(report.outcome() == Outcome::certified);
  report.domain = DomainResult{};
  CHECK(report.outcome() == Outcome::certified);
  report.domain->curves = 1;
  CHECK(report.outcome() == Outcome::invalid);
  report.mesh.verdict = MeshVerdict::undecided;
  CHECK(report.outcome() == Outcome::invalid);
  report.domain.reset();
  CHECK(report.outcome() == Outcome::undecided);
  for (const MeshVerdict verdict :
       {MeshVerdict::invalid_element, MeshVerdict::non_manifold, MeshVerdict::non_conforming,
        MeshVerdict::folded_vertex, MeshVerdict::overlapping_boundary}) {
    report.mesh.verdict = verdict;
    CHECK(report.outcome() == Outcome::invalid);
  }
  report.elements.counts.defects = 1;
  report.mesh.verdict = MeshVerdict::embedding;
  CHECK(report.outcome() == Outcome::contradiction);
}

TEST_CASE("an executor that hides errors or leaves work out certifies nothing") {
  struct Hiding : StdThreads {
    void run(std::size_t count, const std::function<void(std::size_t)>& work) override {
      for (std::size_t i = 0; i < count; ++i) {
        try {
          work(i);
        } catch (...) {
        }
      }
    }
  };
  struct Idle : StdThreads {
    void run(std::size_t, const std::function<void(std::size_t)>&) override {}
  };
  Hiding hiding;
  Idle idle;
  EachElement stops([](std::size_t, const CheckedElement&) { throw std::runtime_error("stop"); });
  CheckOptions options;
  options.executor = &hiding;
  CHECK_THROWS_AS(check_mesh(squares(70, 3), options, stops), std::logic_error);
  options.executor = &idle;
  CHECK_THROWS_AS(check_mesh(squares(70), options), std::logic_error);
}

TEST_CASE("options that are none are refused") {
  CheckOptions options;
  options.criteria = {find_criterion("no such criterion")};
  CHECK_THROWS_AS(check_mesh(squares(2), options), std::invalid_argument);
  const auto numbers = [](std::vector<double> values) { return ExactVector(std::move(values)); };
  // No points; one point; counts that do not fit; weights that are not positive.
  const InputCurve bad[] = {{},
                            {numbers({1}), numbers({1}), {}, "", 0},
                            {numbers({0, 1}), numbers({0}), {}, "", 0},
                            {numbers({0, 1}), numbers({0, 1}), numbers({1}), "", 0},
                            {numbers({0, 1}), numbers({0, 1}), numbers({1, 0}), "", 0},
                            {numbers({0, 1}), numbers({0, 1}), numbers({-1, -1}), "", 0}};
  for (const InputCurve& curve : bad) {
    CheckOptions with_curve;
    with_curve.curves = std::span(&curve, 1);
    CHECK_THROWS_AS(check_mesh(squares(2), with_curve), std::invalid_argument);
  }
  // The bottom side of the square is one.
  const InputCurve good{numbers({0, 1, 2}), numbers({0, 0, 0}), {}, "", 0};
  CheckOptions with_curve;
  with_curve.curves = std::span(&good, 1);
  CHECK(check_mesh(squares(2), with_curve).outcome() == Outcome::certified);
}

TEST_CASE("reports and certificates follow a range of elements as well") {
  const Mesh mesh = squares(3, 2);
  for (const ReportFormat& format : report_formats()) {
    std::ostringstream text;
    const auto report = format.make(text, {"mesh", "", ""});
    check_elements(mesh, 3, 6, {}, *report);
    CHECK(text.str().find("reversed") != std::string::npos);
  }
  std::ostringstream text;
  CertificateWriter writer(text, {"", "mixed", Numbers::decimal});
  check_elements(mesh, 3, 6, {}, writer);
  CHECK(text.str().find("reversed") != std::string::npos);
}
