#include "bezcert/criterion/coefficients.hpp"
#include "bezcert/criterion/cone.hpp"
#include "bezcert/criterion/control_net.hpp"
#include "bezcert/criterion/criterion.hpp"
#include "bezcert/criterion/orientation.hpp"
#include "bezcert/criterion/subdivision.hpp"

#include <array>

namespace bezcert {
namespace {

// The order of reports. One line a criterion.
constexpr std::array registered = {
    control_net_info, orientation_info, cone_info, coefficients_info, subdivision_info,
};

}  // namespace

std::span<const Criterion> criteria() { return registered; }

std::vector<const Criterion*> all_criteria() {
  std::vector<const Criterion*> result;
  for (const Criterion& criterion : registered) result.push_back(&criterion);
  return result;
}

const Criterion* find_criterion(std::string_view name) {
  for (const Criterion& criterion : registered) {
    if (criterion.name == name) return &criterion;
  }
  return nullptr;
}

}  // namespace bezcert
