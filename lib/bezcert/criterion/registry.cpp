#include "bezcert/criterion/coefficients.hpp"
#include "bezcert/criterion/cone.hpp"
#include "bezcert/criterion/control_net.hpp"
#include "bezcert/criterion/criterion.hpp"
#include "bezcert/criterion/orientation.hpp"
#include "bezcert/criterion/subdivision.hpp"

#include <array>

namespace bezcert {
namespace {

Verdict subdivision_with_defaults(const Forms& forms) { return subdivision(forms); }

constexpr std::array all_criteria = {
    Criterion{"control-net", "XC15 Theorem 2.1, for any degree",
              "every upright control triangle is counter-clockwise => det J > 0 (polynomial triangles)",
              Claim::regular, Standing::claimed, true, control_net},
    Criterion{
        "orientation", "YLC22 Theorem 1",
        "every triple of control points is oriented like its indices => injective, for all positive weights",
        Claim::injective, Standing::sound, false, orientation_criterion},
    Criterion{"cone", "KMC22 Theorem 1 with Definition 5",
              "the five conditions on a guardable curve edge => injective", Claim::injective,
              Standing::claimed, true, cone},
    Criterion{"coefficients", "DOS99, EE20",
              "Bernstein coefficients of N >= 0 and corner ones > 0 => det J > 0", Claim::regular,
              Standing::sound, false, coefficients},
    Criterion{"subdivision", "adaptive Bernstein subdivision",
              "the coefficient condition on every piece of a subdivision => det J > 0, with bounds of det J",
              Claim::regular, Standing::sound, false, subdivision_with_defaults},
};

}  // namespace

std::string_view name(Standing standing) { return standing == Standing::sound ? "sound" : "claimed"; }

std::span<const Criterion> criteria() { return all_criteria; }

const Criterion* find_criterion(std::string_view name) {
  for (const Criterion& criterion : all_criteria) {
    if (criterion.name == name) return &criterion;
  }
  return nullptr;
}

}  // namespace bezcert
