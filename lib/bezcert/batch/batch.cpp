#include "bezcert/batch/batch.hpp"

#include "bezcert/number/outward_double.hpp"

#include <algorithm>

namespace bezcert::batch {
namespace {

// The best instructions that this processor has. Results do not depend on it: a block only ever says what
// is certain, and what it leaves open is decided otherwise.
BlockFunction* best_block() {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512dq")) {
    return run_block_avx512;
  }
  if (__builtin_cpu_supports("avx2")) return run_block_avx2;
#endif
  return run_block_baseline;
}

// Whether all four bounds are known.
bool round_bounds(const BlockResult& block, int k, DeterminantBounds& bounds) {
  const auto lower = [&](BlockResult::Bound bound) { return block.lower[bound][k]; };
  const auto upper = [&](BlockResult::Bound bound) { return block.upper[bound][k]; };
  using B = BlockResult;
  const auto min_lower = round_down_positive(lower(B::min_lower), upper(B::min_lower));
  const auto min_upper = round_up_positive(lower(B::min_upper), upper(B::min_upper));
  const auto max_lower = round_down_positive(lower(B::max_lower), upper(B::max_lower));
  const auto max_upper = round_up_positive(lower(B::max_upper), upper(B::max_upper));
  if (!min_lower || !min_upper || !max_lower || !max_upper) return false;
  bounds = {*min_lower, *min_upper, *max_lower, *max_upper};
  return true;
}

}  // namespace

void settle(const BlockTable& table, const Nodes& nodes, std::span<const std::size_t> first_node,
            std::span<Settled> results) {
  static BlockFunction* const run_block = best_block();
  const InjectivityProof proof =
      table.midpoint ? InjectivityProof::midpoint : InjectivityProof::jacobian_hull;
  BlockResult block;
  for (std::size_t begin = 0; begin < first_node.size(); begin += lane_count) {
    const std::size_t count = std::min<std::size_t>(lane_count, first_node.size() - begin);
    std::size_t first[lane_count];
    for (std::size_t k = 0; k < lane_count; ++k) first[k] = first_node[begin + std::min(k, count - 1)];
    run_block(table, nodes, first, block);
    for (std::size_t k = 0; k < count; ++k) {
      Settled& result = results[begin + k];
      result.settled = block.settled[k] && round_bounds(block, static_cast<int>(k), result.bounds);
      result.injectivity_proof = proof;
    }
  }
}

}  // namespace bezcert::batch
