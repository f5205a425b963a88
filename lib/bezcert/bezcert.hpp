// bezcert: exact verification of curved planar meshes. This header is all that a program needs.
//
//   #include <bezcert/bezcert.hpp>
//   #include <iostream>
//
//   int main() {
//     using namespace bezcert;
//     // Two quadratic triangles on the unit square, as a solver has them: points, and six nodes each, in
//     rows
//     // from the first edge on: corner 0, its middle, corner 1; two middles; corner 2.
//     const double points[] = {0, 0,  .5, 0,  1, 0,  0, .5,  .5, .5,  1, .5,  0, 1,  .5, 1,  1, 1};
//     const int nodes[] = {0, 1, 2, 3, 4, 6,   8, 7, 6, 5, 4, 2};
//     MeshBuilder builder;
//     builder.add_nodes_interleaved(points);
//     builder.add_elements(Shape::triangle(2), Basis::lagrange, nodes);
//     const Mesh mesh = std::move(builder).build();
//
//     const MeshReport report = check_mesh(mesh);
//     for (const BadElement& bad : report.elements.bad)
//       std::cout << "element " << bad.element << ": " << describe(bad.decision) << '\n';
//     std::cout << name(report.mesh.verdict) << '\n';  // embedding
//   }
//
// Everything is exact: coordinates are doubles or rationals, a verdict is a theorem, its evidence is in the
// report. Bad data is refused when a mesh or an element is made (std::invalid_argument) or read (InputError);
// the functions below then have no preconditions on values. The library prints nothing, starts no threads and
// keeps no state but tables. It needs the ordinary floating-point environment: rounding to nearest, and
// subnormal numbers kept (no -ffast-math in the program that links it). More programs: examples/. What the
// verdicts mean: docs/mesh.md, docs/decision.md.
#pragma once

#include "bezcert/certificate/certificate.hpp"
#include "bezcert/check/check_mesh.hpp"
#include "bezcert/decide/decide.hpp"
#include "bezcert/io/curve/read.hpp"
#include "bezcert/io/file.hpp"
#include "bezcert/io/input_error.hpp"
#include "bezcert/io/mesh/bez_json.hpp"
#include "bezcert/io/mesh/read.hpp"
#include "bezcert/mesh/mesh_builder.hpp"
#include "bezcert/report/decision_text.hpp"
#include "bezcert/report/report.hpp"
#include "bezcert/report/text_report.hpp"
#include "bezcert/version.hpp"
