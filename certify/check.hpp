// certify check: every element of every mesh, by every chosen criterion and by exact decision, and the mesh
// as a whole.
#pragma once

#include "bezcert/check/check_mesh.hpp"
#include "bezcert/io/mesh/read.hpp"

#include <string>
#include <vector>

namespace bezcert::certify {

struct CheckArguments {
  std::vector<std::string> meshes;
  ReadOptions read;
  std::vector<const Criterion*> criteria;
  std::string format = "text";  ///< a name of report_formats()
  std::string output;           ///< empty: standard output
  std::string curves;           ///< a file of curves the meshes are to conform to; empty: none
  std::string certificate;      ///< where to write the proof for `verifier`; empty: none. One mesh only.
  std::string elements;         ///< where to write the mesh as exact .bez.json; empty: none. One mesh only.
  bool fail_on_undecided = true;
  Budget budget;
  int jobs = 0;                ///< threads; 0: one a core. Reports do not depend on it
  Filter filter = Filter::on;  ///< off: elements are decided by integers alone, with the same report
};

/// The exit code. Throws InputError.
int check(const CheckArguments& arguments);

}  // namespace bezcert::certify
