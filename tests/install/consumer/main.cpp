// The smallest useful program with the installed library.
#include <bezcert/decide/decide.hpp>

#include <iostream>

int main() {
  using namespace bezcert;
  // The unit triangle of degree 2 whose node in the middle of the hypotenuse's neighbour is moved to (0.5,
  // 0.45): as a Lagrange node, det J at corner 1 is 1 - 4 * 0.45 = -4/5.
  const Element element(
      Shape::triangle(2), Basis::lagrange,
      ExactVector({Rational(0), Rational(1, 2), Rational(1), Rational(0), Rational(1, 2), Rational(0)}),
      ExactVector({Rational(0), Rational(9, 20), Rational(0), Rational(1, 2), Rational(1, 2), Rational(1)}));
  const Forms forms(element);
  const Decision decision = decide(forms);
  std::cout << name(decision.verdict);
  if (decision.witness) {
    std::cout << " at " << to_string(decision.witness->parameter) << " det "
              << to_string(decision.witness->determinant);
  }
  std::cout << '\n';
  return 0;
}
