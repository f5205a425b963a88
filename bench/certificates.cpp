// What certificates cost: their size against the mesh file, `certify` with and without writing one, and
// `verifier` against `certify`. The programs as a user runs them, whole processes, one thread, one run.
//
//   certificates [TARGET_TRIANGLES]     default 80,000
//
// The mesh is made on the spot by gmsh: a plate with 9 holes, triangles of order 2, 3 and 4, ASCII .msh 4.1.
// `certify` runs with --criteria=none: the criteria, which run if nothing is said, make its own part of the
// ratios look better; the last line has them. Times are the best of five, the commands in turn.
#include "gmsh_mesh.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

namespace {

namespace fs = std::filesystem;

bool run_order(int order, const fs::path& folder) {
  const std::string mesh = folder / "plate.msh", certificate = folder / "plate.cert";
  gmsh::model::mesh::setOrder(order);
  gmsh::write(mesh);
  const std::string all = CERTIFY_PROGRAM " check --jobs=1 --format=jsonl -o /dev/null " + mesh;
  const std::string check = all + " --criteria=none";
  const std::array<std::string, 4> commands = {check, check + " --certificate=" + certificate,
                                               VERIFIER_PROGRAM " " + mesh + " " + certificate, all};
  std::array<double, 4> best = {1e300, 1e300, 1e300, 1e300};
  for (int k = 0; k < 5; ++k) {
    for (std::size_t i = 0; i < commands.size(); ++i) {
      int code = 0;
      const bool shown = k == 0 && i == 2;  // the verifier's own words, once
      const double time =
          seconds([&] { code = std::system((commands[i] + (shown ? "" : " > /dev/null")).c_str()); });
      if (code != 0) {
        std::cerr << "failed: " << commands[i] << '\n';
        return false;
      }
      best[i] = std::min(best[i], time);
    }
  }
  const auto mesh_size = static_cast<double>(fs::file_size(mesh));
  const auto certificate_size = static_cast<double>(fs::file_size(certificate));
  std::printf("order %d: mesh file %.1f MB, certificate %.1f MB\n", order, mesh_size / 1e6,
              certificate_size / 1e6);
  std::printf("  certificate / mesh file             %5.2f   (asked: at most 0.5)\n",
              certificate_size / mesh_size);
  std::printf("  certify with / without certificate  %5.2f   (asked: at most 1.5)   %.2f s / %.2f s\n",
              best[1] / best[0], best[1], best[0]);
  std::printf("  verifier / certify                  %5.2f   (asked: at most 10)    %.2f s / %.2f s\n",
              best[2] / best[0], best[2], best[0]);
  std::printf("  verifier / certify, all criteria    %5.2f                          %.2f s / %.2f s\n",
              best[2] / best[3], best[2], best[3]);
  std::fflush(stdout);
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  const double target = argc > 1 ? std::atof(argv[1]) : 80000;
  if (!(target >= 100)) {
    std::cerr << "certificates [TARGET_TRIANGLES]: at least 100\n";
    return 2;
  }
  start_gmsh();
  make_plate(target);
  const fs::path folder = fs::temp_directory_path() / "bezcert_certificates";
  fs::create_directories(folder);
  bool good = true;
  for (const int order : {2, 3, 4}) good = good && run_order(order, folder);
  fs::remove_all(folder);
  gmsh::finalize();
  return good ? 0 : 1;
}
