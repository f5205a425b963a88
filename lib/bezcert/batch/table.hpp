// The constants and error bounds of a block, for a shape in a basis.
#pragma once

#include "bezcert/batch/block.hpp"
#include "bezcert/element/element.hpp"

namespace bezcert::batch {

/// The table, built on first use and kept, or null where blocks do not apply: degrees above max_block_degree,
/// rational quadrilaterals, rational elements in the lagrange basis, and shapes whose bounds are too large.
const BlockTable* find_block_table(Shape shape, Basis basis, bool rational);

}  // namespace bezcert::batch
