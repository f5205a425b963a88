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
constexpr std::array all_criteria = {
    control_net_info, orientation_info, cone_info, coefficients_info, subdivision_info,
};

}  // namespace

std::span<const Criterion> criteria() { return all_criteria; }

const Criterion* find_criterion(std::string_view name) {
  for (const Criterion& criterion : all_criteria) {
    if (criterion.name == name) return &criterion;
  }
  return nullptr;
}

}  // namespace bezcert
