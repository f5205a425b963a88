// Exit codes of certify, worst first where several apply: 4, 2, 1, 3, 0.
#pragma once

#include "bezcert/check/check_mesh.hpp"

namespace bezcert::certify {

inline constexpr int exit_certified = 0;
inline constexpr int exit_invalid = 1;      ///< an element, or the mesh as a whole
inline constexpr int exit_input_error = 2;  ///< usage or input
inline constexpr int exit_undecided = 3;
inline constexpr int exit_contradiction = 4;  ///< a sound criterion contradicts the decision

constexpr int exit_code_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::certified: return exit_certified;
    case Outcome::undecided: return exit_undecided;
    case Outcome::invalid: return exit_invalid;
    case Outcome::contradiction: return exit_contradiction;
  }
  return exit_contradiction;
}

}  // namespace bezcert::certify
