// Exit codes of certify, worst first where several apply: 4, 2, 1, 3, 0.
#pragma once

namespace bezcert::certify {

inline constexpr int exit_certified = 0;
inline constexpr int exit_invalid = 1;      ///< an element, or the mesh as a whole
inline constexpr int exit_input_error = 2;  ///< usage or input
inline constexpr int exit_undecided = 3;
inline constexpr int exit_contradiction = 4;  ///< a sound criterion contradicts the decision

}  // namespace bezcert::certify
