// The block for any processor of the target; flags in lib/CMakeLists.txt.
#include "bezcert/batch/block_impl.hpp"

namespace bezcert::batch {

void run_block_baseline(const BlockTable& table, const Nodes& nodes, const std::size_t* first,
                        BlockResult& result) {
  run_block(table, nodes, first, result);
}

}  // namespace bezcert::batch
