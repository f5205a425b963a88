// What happens where FLINT, which is loaded when algebra is first needed, is not there.
#pragma once

#include <stdexcept>

namespace bezcert {

/// Thrown by whatever needs algebra: decisions, contacts of curves, certificates.
class FlintMissing : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace bezcert
