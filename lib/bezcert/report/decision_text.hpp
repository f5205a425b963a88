// The words for what the decision says of one element: the only place where they are made.
#pragma once

#include "bezcert/verdict/decision.hpp"

#include <string>
#include <vector>

namespace bezcert {

/// "folded, det J = -4/5 at (1, 0, 0), the point (0.5, 0.25)": one line for people. The point in decimal.
std::string describe(const Decision& decision);

/// "(0.5, 0.25)": the numbers of a point in decimal, for people; or exactly.
std::string decimal_text(const std::vector<Rational>& numbers);
std::string exact_text(const std::vector<Rational>& numbers);

/// "budget: subdivision pieces 4096; budget: algebra bits ...": what an open decision lacks, or an empty
/// text.
std::string open_text(const Decision& decision);

/// "subdivision pieces 4096".
std::string text_of(const ExhaustedBudget& budget);

}  // namespace bezcert
