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
  Shape shape = net.shape;
  --shape.p;
  if (shape.domain == Domain::square) --shape.q;
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
  Vector<T> result{take(net.x), take(net.y), {}};
  if (net.rational()) result.z = take(net.w);
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
  for (int r = 0; r <= f.shape.q; ++r) {
    for (int c = 0; c <= f.shape.p; ++c) sum.at(r + b, c + a) += f.at(r, c);
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

// Evaluation of the map is homogeneous: parameters are integers over a common denominator, and the
// denominator's powers cancel or are divided by at the end. Fractions would be reduced at every step.
struct Point {
  Integer x, y, w;
};

Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y, a.w - b.w}; }
Point mix(const Integer& s, const Point& a, const Integer& t, const Point& b) {
  return {s * a.x + t * b.x, s * a.y + t * b.y, s * a.w + t * b.w};
}
Integer determinant(const Point& a, const Point& b, const Point& c) {
  return a.x * (b.y * c.w - b.w * c.y) - a.y * (b.x * c.w - b.w * c.x) + a.w * (b.x * c.y - b.y * c.x);
}

// The numerators of a parameter (two numbers for each direction of the square: of 1 - t and of t), and the
// denominators: one, or one a direction.
struct IntegerParameter {
  std::vector<Integer> numerators;
  Integer first, second = 1;
};

Integer numerator_over(const Rational& value, const Integer& common) {
  return Integer(numerator(value)) * (common / Integer(denominator(value)));
}

IntegerParameter integer_parameter(const Parameter& parameter) {
  IntegerParameter result;
  if (parameter.size() == 3) {
    result.first = 1;
    for (const Rational& t : parameter) result.first = lcm(result.first, Integer(denominator(t)));
    for (const Rational& t : parameter) result.numerators.push_back(numerator_over(t, result.first));
    return result;
  }
  result.first = denominator(parameter[0]);
  result.second = denominator(parameter[1]);
  for (const Rational& t : parameter) {
    result.numerators.push_back(denominator(t) - numerator(t));
    result.numerators.push_back(numerator(t));
  }
  return result;
}

// de Casteljau with the integer parameter: the value times the denominators to the powers of the degrees.
Integer homogeneous_value(const Polynomial<Integer>& f, const std::vector<Integer>& t) {
  if (f.shape.domain == Domain::triangle) return evaluate(f, t);
  std::vector<Integer> c = f.coefficients;
  const std::size_t columns = static_cast<std::size_t>(f.shape.p) + 1;
  const std::size_t rows = static_cast<std::size_t>(f.shape.q) + 1;
  const auto collapse = [&c](std::size_t first, std::size_t stride, std::size_t count, const Integer& low,
                             const Integer& high) {
    for (std::size_t n = count; n > 1; --n) {
      for (std::size_t i = 0; i + 1 < n; ++i) {
        c[first + i * stride] = low * c[first + i * stride] + high * c[first + (i + 1) * stride];
      }
    }
  };
  for (std::size_t r = 0; r < rows; ++r) collapse(r * columns, 1, columns, t[0], t[1]);
  collapse(0, columns, rows, t[2], t[3]);
  return c[0];
}

}  // namespace

Shape numerator_shape(Shape element, bool rational) {
  const int factor = rational ? 3 : 2;
  if (element.domain == Domain::triangle) return {Domain::triangle, factor * (element.p - 1), 0};
  return {Domain::square, factor * (element.p - 1) + 1, factor * (element.q - 1) + 1};
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

Rational jacobian_determinant(const Element& element, const Parameter& parameter) {
  const ExactNet exact = exact_net(element);
  const Net<Integer>& net = exact.net;
  const bool triangle = element.is_triangle();
  if (parameter.size() != (triangle ? 3U : 2U)) {
    throw std::invalid_argument("jacobian_determinant: wrong number of parameters");
  }
  const IntegerParameter at = integer_parameter(parameter);
  const std::vector<Integer>& t = at.numerators;
  Shape shape = net.shape;
  --shape.p;
  if (!triangle) --shape.q;
  // What W = 1 is multiplied by.
  Integer one = 1;
  for (int k = 0; k < shape.p; ++k) one *= at.first;
  for (int k = 0; k < shape.q; ++k) one *= at.second;
  // The sub-nets evaluated at the parameter: the last step of de Casteljau's algorithm.
  const auto sub_point = [&](int row_shift, int column_shift) {
    const auto component = [&](const std::vector<Integer>& from) {
      Polynomial<Integer> f(shape);
      for (int r = 0; r < row_count(shape); ++r) {
        for (int c = 0; c < column_count(shape, r); ++c) {
          f.at(r, c) = from[coefficient_index(net.shape, r + row_shift, c + column_shift)];
        }
      }
      return homogeneous_value(f, t);
    };
    return Point{component(net.x), component(net.y), net.rational() ? component(net.w) : one};
  };
  const Rational scale = exact.scale * exact.scale * Rational(degree_factor(net.shape));
  if (triangle) {
    const Point f0 = sub_point(0, 0);
    const Point f1 = sub_point(0, 1);
    const Point f2 = sub_point(1, 0);
    // The determinant has the denominator to the 3 (n - 1), the weight to the n.
    const Integer weight = t[0] * f0.w + t[1] * f1.w + t[2] * f2.w;
    const Integer cubes = at.first * at.first * at.first * determinant(f0, f1, f2);
    return scale * Rational(cubes, Integer(weight * weight * weight));
  }
  const Point f00 = sub_point(0, 0);
  const Point f10 = sub_point(0, 1);
  const Point f01 = sub_point(1, 0);
  const Point f11 = sub_point(1, 1);
  const Point bottom = mix(t[0], f00, t[1], f10);
  const Point top = mix(t[0], f01, t[1], f11);
  // With K the sub-points' factor: the point has K first second, the derivatives K second and K first.
  const Point point = mix(t[2], bottom, t[3], top);
  const Point along_u = mix(t[2], f10 - f00, t[3], f11 - f01);
  const Point along_v = top - bottom;
  const Integer value = at.first * at.second * determinant(point, along_u, along_v);
  return scale * Rational(value, Integer(point.w * point.w * point.w));
}

}  // namespace bezcert
