#include "memory.hpp"

#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace bezcert::certify {

void expect_memory([[maybe_unused]] std::size_t bytes) {
#if defined(__GLIBC__) && defined(MADV_HUGEPAGE)
  constexpr std::size_t large_page = std::size_t{1} << 21;
  if (bytes < 2 * large_page) return;
  // Up to this size on the heap, which is not given back before the end.
  ::mallopt(M_MMAP_THRESHOLD, 1 << 25);
  ::mallopt(M_TRIM_THRESHOLD, 1 << 30);
  ::mallopt(M_TOP_PAD, static_cast<int>(std::min<std::size_t>(bytes, 1 << 30)));
  const auto before = reinterpret_cast<std::uintptr_t>(::sbrk(0));
  void* volatile grown = std::malloc(1 << 20);  // volatile: else the compiler leaves out the pair
  std::free(grown);
  const auto after = reinterpret_cast<std::uintptr_t>(::sbrk(0));
  const std::uintptr_t first = (before + large_page - 1) / large_page * large_page;
  if (after > first + large_page) ::madvise(reinterpret_cast<void*>(first), after - first, MADV_HUGEPAGE);
  ::mallopt(M_TOP_PAD, 1 << 17);
#endif
}

}  // namespace bezcert::certify
