// A limit of memory for the time of a test: who believes a number in a file and reserves for it fails.
#pragma once

#include <sys/resource.h>

#include <catch2/catch.hpp>

namespace bezcert::test {

class MemoryLimit {
 public:
  explicit MemoryLimit(rlim_t bytes) {
    REQUIRE(::getrlimit(RLIMIT_AS, &before_) == 0);
    rlimit limit = before_;
    if (limit.rlim_cur == RLIM_INFINITY || limit.rlim_cur > bytes) limit.rlim_cur = bytes;
      // A sanitizer needs terabytes of address space for its own tables.
#if !defined(__SANITIZE_ADDRESS__)
    REQUIRE(::setrlimit(RLIMIT_AS, &limit) == 0);
#endif
  }
  ~MemoryLimit() { ::setrlimit(RLIMIT_AS, &before_); }
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;

 private:
  rlimit before_{};
};

}  // namespace bezcert::test
