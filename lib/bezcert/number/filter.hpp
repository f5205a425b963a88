// Whether floating point may be asked before exact numbers.
#pragma once

namespace bezcert {

/// Whether to try doubles and intervals before exact integers. Answers do not depend on it (tests check).
enum class Filter { on, off };

}  // namespace bezcert
