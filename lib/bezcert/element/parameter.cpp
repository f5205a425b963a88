#include "bezcert/element/parameter.hpp"

namespace bezcert {
namespace {

// Calls visit(dimension of the simplex, position of the factor's first value) for every factor.
template <class Visit>
void for_each_factor(Domain domain, Visit visit) {
  std::size_t first = 0;
  for (int f = 0; f < domain.factor_count(); ++f) {
    const auto simplex = static_cast<std::size_t>(domain.simplex(f));
    visit(simplex, first);
    first += simplex == 1 ? 1 : simplex + 1;
  }
}

}  // namespace

Parameter::Parameter(Domain domain, std::vector<Rational> values)
    : domain_(domain), values_(std::move(values)) {
  if (values_.size() != parameter_size(domain)) {
    throw std::invalid_argument("the number of parameters does not fit the domain");
  }
  for_each_factor(domain, [&](std::size_t simplex, std::size_t first) {
    if (simplex == 1) return;
    Rational sum = 0;
    for (std::size_t k = 0; k <= simplex; ++k) sum += values_[first + k];
    if (sum != 1) throw std::invalid_argument("barycentric parameters must sum to 1");
  });
}

Parameter Parameter::at(Domain domain, const std::vector<Rational>& affine) {
  if (affine.size() != static_cast<std::size_t>(domain.dimension())) {
    throw std::invalid_argument("the number of coordinates does not fit the domain");
  }
  std::vector<Rational> values;
  auto next = affine.begin();
  for_each_factor(domain, [&](std::size_t simplex, std::size_t) {
    const auto end = next + static_cast<std::ptrdiff_t>(simplex);
    if (simplex > 1) {
      Rational rest = 1;
      for (auto value = next; value != end; ++value) rest -= *value;
      values.push_back(std::move(rest));
    }
    values.insert(values.end(), next, end);
    next = end;
  });
  return {domain, std::move(values)};
}

std::vector<Rational> Parameter::affine() const {
  std::vector<Rational> result;
  for_each_factor(domain_, [&](std::size_t simplex, std::size_t first) {
    if (simplex > 1) ++first;
    for (std::size_t k = 0; k < simplex; ++k) result.push_back(values_[first + k]);
  });
  return result;
}

bool Parameter::is_inside() const {
  bool inside = true;
  for_each_factor(domain_, [&](std::size_t simplex, std::size_t first) {
    if (simplex == 1 && values_[first] > 1) inside = false;
  });
  for (const Rational& value : values_) inside = inside && value.sign() >= 0;
  return inside;
}

std::string to_string(const Parameter& parameter) {
  std::string text = "(";
  for (const Rational& value : parameter.values()) {
    if (text.size() > 1) text += ", ";
    text += to_string(value);
  }
  return text + ")";
}

}  // namespace bezcert
