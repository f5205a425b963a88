// Memory for large meshes: taken from the system in few large pages.
#pragma once

#include <cstddef>

namespace bezcert::certify {

/// Says that about so many bytes will be needed. Only speed depends on it: of a mesh of 10 MB a tenth of the
/// time went into single pages of 4 KiB, each given back and taken again (docs/performance.md). Does nothing
/// for little, and where the C library is not glibc.
void expect_memory(std::size_t bytes);

}  // namespace bezcert::certify
