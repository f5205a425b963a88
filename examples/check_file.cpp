// Reads a mesh file, checks it, and writes the report that `certify check` would write.
//
//   check_file MESH
#include <bezcert/bezcert.hpp>

#include <iostream>

int main(int argc, char** argv) {
  using namespace bezcert;
  if (argc != 2) {
    std::cerr << "usage: check_file MESH\n";
    return 2;
  }
  try {
    const std::string path = argv[1];
    const Mesh mesh = read_mesh_file(path);

    // A report is an observer: it writes while the check runs. What it writes is also in the MeshReport.
    const auto text = make_text_report(std::cout, {path});
    CheckOptions options;
    options.criteria = all_criteria();
    const MeshReport report = check_mesh(mesh, options, *text);

    for (const BadElement& bad : report.elements.bad) {
      std::cout << "bad: element " << mesh.origin().number(bad.element) << " is "
                << name(bad.decision.verdict) << '\n';
    }
    return report.outcome() == Outcome::certified ? 0 : 1;
  } catch (const InputError& error) {
    std::cerr << error.what() << '\n';  // file, line, what would be right
    return 2;
  }
}
