#include "bezcert/verdict/decision.hpp"

namespace bezcert {

bool certainly_invalid(const Decision& decision) {
  return is_invalid(decision.verdict) ||
         (decision.verdict == ElementVerdict::undecided && decision.witness.has_value());
}

}  // namespace bezcert
