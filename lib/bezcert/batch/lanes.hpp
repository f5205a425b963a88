// Eight doubles at once: one number of each of eight elements.
//
// A vector type of the compiler: the same statements become SSE2, AVX2 or AVX-512 instructions, according
// to the flags of the file that includes this. The type has internal linkage on purpose: every file's
// templates over it are its own, so that no function compiled for one processor is ever taken for that of
// another.
#pragma once

#define BEZCERT_INLINE [[gnu::always_inline]] inline

namespace bezcert::batch {

inline constexpr int lane_count = 8;

namespace {

struct Lanes {
  using Vector [[gnu::vector_size(lane_count * sizeof(double))]] = double;
  Vector v;
};

BEZCERT_INLINE Lanes operator+(const Lanes& a, const Lanes& b) { return {a.v + b.v}; }
BEZCERT_INLINE Lanes operator-(const Lanes& a, const Lanes& b) { return {a.v - b.v}; }
BEZCERT_INLINE Lanes operator*(const Lanes& a, const Lanes& b) { return {a.v * b.v}; }
BEZCERT_INLINE Lanes operator/(const Lanes& a, const Lanes& b) { return {a.v / b.v}; }
BEZCERT_INLINE Lanes operator*(const Lanes& a, double constant) { return {a.v * constant}; }

BEZCERT_INLINE Lanes smaller(const Lanes& a, const Lanes& b) { return {a.v < b.v ? a.v : b.v}; }
BEZCERT_INLINE Lanes larger(const Lanes& a, const Lanes& b) { return {a.v > b.v ? a.v : b.v}; }
BEZCERT_INLINE Lanes absolute(const Lanes& a) { return {a.v < 0.0 ? -a.v : a.v}; }
BEZCERT_INLINE Lanes as_exact(const Lanes& a) { return a; }

}  // namespace
}  // namespace bezcert::batch
