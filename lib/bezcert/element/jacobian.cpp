#include "bezcert/element/jacobian.hpp"

#include "bezcert/bernstein/scale_table.hpp"

namespace bezcert {
namespace {

// A vector-valued polynomial: scaled Bernstein coefficients of the components; z is unused if polynomial.
template <class T>
struct Vector {
  Polynomial<T> x, y, z;
};

// The sub-net of the control points shifted by (row, column), one degree less, in scaled coefficients.
template <class T>
Vector<T> sub_net(const Net<T>& net, int row_shift, int column_shift) {
  const Shape shape = net.shape.all_raised(-1);
  const std::vector<T>& factors = scale_table(shape).template multinomials_as<T>();
  const auto take = [&](const std::vector<T>& from) {
    Polynomial<T> result;
    result.shape = shape;
    result.coefficients.reserve(factors.size());
    for (int r = 0; r < row_count(shape); ++r) {
      for (int c = 0; c < column_count(shape, r); ++c) {
        const std::size_t i = coefficient_index(net.shape, r + row_shift, c + column_shift);
        result.coefficients.push_back(from[i] * factors[result.coefficients.size()]);
      }
    }
    return result;
  };
  Vector<T> result{take(net.coordinates[0]), take(net.coordinates[1]), {}};
  if (net.rational()) result.z = take(net.weights);
  return result;
}

template <class T>
Polynomial<T> difference(const Polynomial<T>& a, const Polynomial<T>& b) {
  Polynomial<T> result = a;
  for (std::size_t i = 0; i < b.coefficients.size(); ++i) result.coefficients[i] -= b.coefficients[i];
  return result;
}

template <class T>
Vector<T> difference(const Vector<T>& a, const Vector<T>& b) {
  return {difference(a.x, b.x), difference(a.y, b.y), difference(a.z, b.z)};
}

// a b - c d.
template <class T>
Polynomial<T> cross(const Polynomial<T>& a, const Polynomial<T>& b, const Polynomial<T>& c,
                    const Polynomial<T>& d) {
  Polynomial<T> result = convolve(a, b);
  return difference(result, convolve(c, d));
}

template <class T>
Vector<T> cross(const Vector<T>& a, const Vector<T>& b) {
  return {cross(a.y, b.z, a.z, b.y), cross(a.z, b.x, a.x, b.z), cross(a.x, b.y, a.y, b.x)};
}

template <class T>
Polynomial<T> dot(const Vector<T>& a, const Vector<T>& b) {
  Polynomial<T> result = convolve(a.x, b.x);
  add_convolution(result, a.y, b.y);
  add_convolution(result, a.z, b.z);
  return result;
}

// [A B C]. Differences first: the homogeneous coordinates are close together, and so intervals stay narrow.
template <class T>
Polynomial<T> bracket(const Vector<T>& a, const Vector<T>& b, const Vector<T>& c, bool rational) {
  const Vector<T> to_b = difference(b, a);
  const Vector<T> to_c = difference(c, a);
  if (!rational) return cross(to_b.x, to_c.y, to_b.y, to_c.x);
  return dot(cross(to_b, to_c), a);
}

// sum += f * (one bilinear function of the square, u^a (1-u)^(1-a) v^b (1-v)^(1-b)), in scaled coefficients.
template <class T>
void add_times_bilinear(Polynomial<T>& sum, const Polynomial<T>& f, int a, int b) {
  for (int r = 0; r < row_count(f.shape); ++r) {
    for (int c = 0; c < column_count(f.shape, r); ++c) sum.at(r + b, c + a) += f.at(r, c);
  }
}

template <class T>
Polynomial<T> scaled_numerator(const Net<T>& net) {
  const bool rational = net.rational();
  if (net.shape.domain == Domain::triangle) {
    return bracket(sub_net(net, 0, 0), sub_net(net, 0, 1), sub_net(net, 1, 0), rational);
  }
  const Vector<T> f00 = sub_net(net, 0, 0);
  const Vector<T> f10 = sub_net(net, 0, 1);
  const Vector<T> f01 = sub_net(net, 1, 0);
  const Vector<T> f11 = sub_net(net, 1, 1);
  Polynomial<T> result(numerator_shape(net.shape, rational));
  add_times_bilinear(result, bracket(f00, f10, f01, rational), 0, 0);
  add_times_bilinear(result, bracket(f10, f11, f00, rational), 1, 0);
  add_times_bilinear(result, bracket(f01, f00, f11, rational), 0, 1);
  add_times_bilinear(result, bracket(f11, f01, f10, rational), 1, 1);
  return result;
}

}  // namespace

Shape numerator_shape(Shape element, bool rational) {
  // det(P*, P*_u, ...) of d + 1 polynomials, or of d derivatives: one degree less in a factor for every
  // derivative along it, and one less again where homogeneous coordinates cancel the highest (Euler's
  // relation).
  Shape result = element;
  for (int f = 0; f < element.factor_count(); ++f) {
    const int degree =
        (element.dimension() + rational) * element.degree(f) - element.domain.simplex(f) - rational;
    result = result.raised(f, degree - element.degree(f));
  }
  return result;
}

const Integer& numerator_multiple(Shape numerator) { return scale_table(numerator).multiple; }

template <class T>
Polynomial<T> jacobian_numerator(const Net<T>& net) {
  Polynomial<T> result = scaled_numerator(net);
  from_scaled(result);
  return result;
}

template Polynomial<Interval> jacobian_numerator(const Net<Interval>&);
template Polynomial<Integer> jacobian_numerator(const Net<Integer>&);

int degree_factor(Shape element) {
  int result = 1;
  for (int i = 0; i < element.dimension(); ++i) {
    result *= element.degree(factor_of_coordinate(element.domain, i));
  }
  return result;
}

}  // namespace bezcert
