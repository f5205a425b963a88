// certify explain: everything known of one element.
#include "bezcert/check/cross_check.hpp"
#include "bezcert/criterion/subdivision.hpp"
#include "bezcert/element/forms.hpp"
#include "bezcert/io/file.hpp"
#include "bezcert/io/input_error.hpp"
#include "bezcert/number/parse.hpp"
#include "bezcert/report/decision_text.hpp"
#include "bezcert/report/mesh_text.hpp"
#include "bezcert/report/text_report.hpp"
#include "exit_code.hpp"
#include "options.hpp"
#include "subcommand.hpp"

#include <algorithm>
#include <iostream>
#include <memory>

namespace bezcert::certify {
namespace {

struct ExplainArguments {
  std::string mesh;
  /// Its number in the file (place from 1 where the format has no numbers), or its name.
  std::string element;
  ReadOptions read;
  Budget budget;
};

std::size_t find_element(const Mesh& mesh, const ExplainArguments& options) {
  for (std::size_t i = 0; i < mesh.elements().size(); ++i) {
    if (std::to_string(mesh.origin().number(i)) == options.element) return i;
  }
  for (std::size_t i = 0; i < mesh.elements().size(); ++i) {
    if (!mesh.origin().name(i).empty() && mesh.origin().name(i) == options.element) return i;
  }
  throw InputError(options.mesh, 0,
                   "there is no element " + options.element + ": expected a number from " +
                       std::to_string(mesh.origin().number(0)) + " to " +
                       std::to_string(mesh.origin().number(mesh.elements().size() - 1)) +
                       ", as in the file, or a name");
}

std::string both(const Rational& value) {
  const std::string exact_text = to_string(value);
  const std::string decimal = to_decimal(value);
  return decimal == exact_text ? exact_text : decimal + " (exactly " + exact_text + ")";
}

void print_witness(const char* label, const Witness& witness) {
  const std::string decimal = decimal_text(witness.place), exactly = exact_text(witness.place);
  std::cout << label << "\n  parameter  " << to_string(witness.parameter) << "\n  decimal    "
            << decimal_text(witness.parameter.values()) << "\n  place      " << decimal;
  if (exactly != decimal) std::cout << " (exactly " << exactly << ")";
  std::cout << "\n  det J      " << both(witness.determinant) << '\n';
}

// A zero of det J with algebraic coordinates, in words.
void print_zero(const AlgebraicZero& zero, bool triangle) {
  std::cout << "zero of det J\n";
  const auto line = [](const char* label, const RealRoot& x) {
    std::cout << "  " << label << "  ";
    if (x.is_rational()) {
      std::cout << both(x.lower) << '\n';
      return;
    }
    std::cout << to_decimal((x.lower + x.upper) / 2, 12) << ", exactly the only ";
    if (x.polynomial.is_zero()) {
      std::cout << "such number";
    } else {
      std::cout << "root of " << to_string(x.polynomial, "x");
    }
    std::cout << " between\n     " << to_string(x.lower) << " and\n     " << to_string(x.upper) << '\n';
  };
  line(triangle ? "u (second barycentric)" : "u", zero.at.u);
  line(triangle ? "v (third barycentric)" : "v", zero.at.v);
  std::cout << "  det J vanishes "
            << (zero.dimension == 0   ? "at finitely many points of the element only"
                : zero.dimension == 1 ? "along a whole curve in the element"
                : zero.dimension == 2 ? "everywhere"
                                      : "at this point (the budget did not tell where else)")
            << '\n';
}

void print_net(const Element& element) {
  const char* what = element.basis() == Basis::bernstein ? "control points" : "nodes";
  std::cout << what << " (" << (element.basis() == Basis::bernstein ? "bernstein" : "lagrange")
            << " basis, rows from the first edge on)\n";
  std::size_t i = 0;
  for (int r = 0; r < row_count(element.shape()); ++r) {
    for (int c = 0; c < column_count(element.shape(), r); ++c, ++i) {
      std::cout << "  row " << r << " column " << c << ": (" << to_decimal(element.coordinates()[0][i], 17)
                << ", " << to_decimal(element.coordinates()[1][i], 17) << ")";
      if (element.rational()) std::cout << " weight " << to_decimal(element.weights()[i], 17);
      std::cout << '\n';
    }
  }
}

// One character a coefficient of N, rows from the last to the first, so that it looks like the domain.
void print_signs(const Forms& forms) {
  const Polynomial<Integer>& n = forms.exact_jacobian().numerator;
  std::cout << "signs of the Bernstein coefficients of the Jacobian numerator, degree " << n.shape.degree(0);
  if (n.shape.domain == Domain::square) std::cout << "x" << n.shape.degree(1);
  std::cout << " (last row on top)\n";
  for (int r = row_count(n.shape) - 1; r >= 0; --r) {
    std::cout << "  ";
    for (int c = 0; c < column_count(n.shape, r); ++c) {
      const int s = sign(n.at(r, c));
      std::cout << (s > 0 ? '+' : s < 0 ? '-' : '0') << (c + 1 < column_count(n.shape, r) ? " " : "");
    }
    std::cout << '\n';
  }
}

void print_bounds(const DeterminantBounds& bounds) {
  const auto line = [](const char* label, const Dyadic& lower, const Dyadic& upper) {
    std::cout << "  " << label << " from " << both(to_rational(lower)) << " to " << both(to_rational(upper))
              << '\n';
  };
  line("min det J:", bounds.min_lower, bounds.min_upper);
  line("max det J:", bounds.max_lower, bounds.max_upper);
  if (sign(bounds.min_lower) > 0) {
    std::cout << "  min / max: from "
              << to_decimal(to_rational(bounds.min_lower) / to_rational(bounds.max_upper)) << " to "
              << to_decimal(to_rational(bounds.min_upper) / to_rational(bounds.max_lower)) << '\n';
  }
}

void print_criteria(const CheckedElement& checked) {
  std::cout << "criteria\n";
  for (const CheckedCriterion& one : checked.criteria) {
    std::cout << "  " << one.criterion->name << " (" << one.criterion->theorem << "; "
              << name(one.criterion->standing) << (one.criterion->refuted ? ", refuted" : "")
              << "; would prove " << name(one.criterion->claim) << "): " << name(one.verdict.status);
    if (!one.verdict.reason.empty()) std::cout << " - " << one.verdict.reason;
    if (one.is_finding()) std::cout << " - FINDING: the decision refutes this claim";
    if (one.is_defect()) std::cout << " - CONTRADICTION: a defect of bezcert";
    std::cout << '\n';
  }
}

// What the element has to do with the mesh not being an embedding. Its neighbours may overlap it: all are
// decided.
void print_mesh_obstacles(const Mesh& mesh, std::size_t index, const CheckedElement& checked,
                          const Budget& budget) {
  if (mesh.elements().size() == 1) return;
  std::vector<ElementState> states;
  for (std::size_t i = 0; i < mesh.elements().size(); ++i) {
    if (i == index) {
      states.push_back(state_of(checked.decision));
    } else {
      const Element other = mesh.element(i);
      states.push_back(state_of(decide(other, budget)));
    }
  }
  const MeshResult result = examine_mesh(mesh, states, {budget.contact, static_cast<std::uint32_t>(index)});
  std::cout << "in the mesh\n";
  std::size_t listed = 0;
  for (const MeshObstacle& obstacle : result.obstacles.all()) {
    if (obstacle.kind() == MeshVerdict::invalid_element) continue;  // said above of this one
    std::cout << "  " << name(obstacle.kind()) << ": " << describe(mesh, obstacle) << '\n';
    ++listed;
  }
  if (listed == 0) std::cout << "  no obstacle names this element\n";
  const bool all_injective =
      std::all_of(states.begin(), states.end(), [](ElementState s) { return s == ElementState::injective; });
  if (!all_injective) {
    std::cout << "  angles and boundaries are not compared while elements of the mesh are invalid or open\n";
  }
}

int exit_code_of(const CheckedElement& checked) {
  for (const CheckedCriterion& one : checked.criteria) {
    if (one.is_defect()) return exit_contradiction;
  }
  if (certainly_invalid(checked.decision)) return exit_invalid;
  return checked.decision.verdict == ElementVerdict::injective ? exit_certified : exit_undecided;
}

// The exit code that `check` would give for this element.
int explain(const ExplainArguments& options) {
  const Mesh mesh = read_mesh(options.mesh, read_file(options.mesh), options.read);
  const std::size_t index = find_element(mesh, options);
  const Element element = mesh.element(index);
  const CheckedElement checked = check_element(element, all_criteria(), options.budget);
  const Decision& decision = checked.decision;
  const Forms forms(element);

  std::cout << element_title(options.mesh, mesh, index) << ": " << describe(decision) << '\n';
  std::cout << (element.rational() ? "rational" : "polynomial") << ", numbers " << name(mesh.origin().numbers)
            << '\n';
  print_net(element);
  std::cout << "verdict: " << name(decision.verdict) << '\n';
  if (is_regular(decision.verdict) || decision.verdict == ElementVerdict::reversed) {
    std::cout << "  sign of det J by " << name(decision.sign_proof) << ", " << decision.pieces << " pieces\n";
  }
  if (decision.injectivity_proof != InjectivityProof::none)
    std::cout << "  injective by " << name(decision.injectivity_proof) << '\n';
  if (!decision.exhausted.empty()) std::cout << "  open: " << open_text(decision) << '\n';
  if (decision.witness) print_witness("witness", *decision.witness);
  if (decision.other_witness) print_witness("det J is not negative everywhere", *decision.other_witness);
  if (decision.zero) print_zero(*decision.zero, element.is_triangle());
  print_signs(forms);
  std::cout << "bounds of det J\n";
  SubdivisionOptions narrow;
  narrow.relative_width = Rational(1, 100);
  print_bounds(*subdivision(forms, narrow).bounds);
  print_criteria(checked);
  print_mesh_obstacles(mesh, index, checked, options.budget);
  return exit_code_of(checked);
}

}  // namespace

Run add_explain(CLI::App& command) {
  const auto arguments = std::make_shared<ExplainArguments>();
  command.add_option("MESH", arguments->mesh, "mesh file")->required();
  command
      .add_option("--element", arguments->element,
                  "its number in the file (.bez.json: its place, from 1) or its name")
      ->required()
      ->option_text("N");
  add_read_options(command, arguments->read);
  add_budget(command, arguments->budget);
  return [arguments] { return explain(*arguments); };
}

}  // namespace bezcert::certify
