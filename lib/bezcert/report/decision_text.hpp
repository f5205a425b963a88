// The words for what the decision says of one element: the only place where they are made.
#pragma once

#include "bezcert/verdict/decision.hpp"

#include <string>

namespace bezcert {

/// "folded, det J = -4/5 at (1, 0, 0)": one line for people.
std::string describe(const Decision& decision);

/// "budget: subdivision pieces 4096; budget: algebra bits ...": what an open decision lacks, or an empty
/// text.
std::string open_text(const Decision& decision);

/// "subdivision pieces 4096".
std::string text_of(const ExhaustedBudget& budget);

}  // namespace bezcert
