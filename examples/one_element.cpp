// Decides one element, and shows the evidence.
//
// The quadratic triangle with its middle node of edge 0-1 pulled upwards folds near corner 1; as a rational
// Bezier triangle, with control points instead of nodes, it does not.
#include <bezcert/bezcert.hpp>

#include <iostream>

namespace {

void show(const bezcert::Element& element) {
  using namespace bezcert;
  const Decision decision = decide(element);
  std::cout << "verdict: " << name(decision.verdict) << '\n';
  if (decision.witness) {
    // Everything is exact: a parameter of the element, its place in the plane, and det J there.
    const Witness& witness = *decision.witness;
    std::cout << "  det J = " << to_string(witness.determinant) << " at the parameter "
              << to_string(witness.parameter) << ", which is the point (" << to_string(witness.place[0])
              << ", " << to_string(witness.place[1]) << ")\n";
  }
  if (decision.verdict == ElementVerdict::injective) {
    std::cout << "  proved by " << name(decision.sign_proof) << " and " << name(decision.injectivity_proof)
              << "; min det J >= " << to_string(to_rational(decision.bounds.min_lower)) << '\n';
  }
}

}  // namespace

int main() {
  using namespace bezcert;
  const auto numbers = [](std::initializer_list<double> values) {
    return ExactVector(std::vector<double>(values));
  };
  // Rows from edge 0-1 upwards: three points, two, one.
  const ExactVector x = numbers({0, 0.5, 1, 0, 0.5, 0});
  const ExactVector y = numbers({0, 0.4375, 0, 0.5, 0.5, 1});
  show(Element(Shape::triangle(2), Basis::lagrange, {x, y}));
  show(Element(Shape::triangle(2), Basis::bernstein, {x, y}, numbers({1, 2, 1, 1, 1, 1})));
  return 0;
}
