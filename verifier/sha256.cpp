// SHA-256 (FIPS 180-4). Its constants are computed: the first 32 bits of the fractions of roots of the first
// primes.
#include "sha256.hpp"

#include <gmpxx.h>

#include <array>
#include <bit>
#include <cstdint>

namespace verifier {

std::string sha256(std::string_view bytes) {
  std::array<std::uint32_t, 64> k;
  std::array<std::uint32_t, 8> state;
  std::size_t found = 0;
  for (unsigned prime = 2; found < k.size(); ++prime) {
    unsigned divisor = 2;
    while (prime % divisor != 0) ++divisor;
    const auto root_bits = [&](unsigned root) {
      mpz_class r = mpz_class(prime) << (32 * root);
      mpz_root(r.get_mpz_t(), r.get_mpz_t(), root);
      return static_cast<std::uint32_t>(r.get_ui());
    };
    if (divisor == prime && found < state.size()) state[found] = root_bits(2);
    if (divisor == prime) k[found++] = root_bits(3);
  }
  const auto digest = [&](const char* block) {
    std::array<std::uint32_t, 64> w{};
    for (std::size_t i = 0; i < 64; ++i) w[i / 4] = w[i / 4] << 8 | static_cast<unsigned char>(block[i]);
    for (std::size_t i = 16; i < 64; ++i) {
      const std::uint32_t x = w[i - 15], y = w[i - 2];
      w[i] = w[i - 16] + w[i - 7] + (std::rotr(x, 7) ^ std::rotr(x, 18) ^ x >> 3) +
             (std::rotr(y, 17) ^ std::rotr(y, 19) ^ y >> 10);
    }
    const std::array<std::uint32_t, 8> before = state;
    auto& [a, b, c, d, e, f, g, h] = state;
    for (std::size_t i = 0; i < 64; ++i) {
      const std::uint32_t s = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
      const std::uint32_t r = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
      const std::uint32_t t = h + s + ((e & f) ^ (~e & g)) + k[i] + w[i];
      const std::uint32_t first = t + r + ((a & b) ^ (a & c) ^ (b & c));
      h = g, g = f, f = e, e = d + t, d = c, c = b, b = a, a = first;
    }
    for (std::size_t i = 0; i < 8; ++i) state[i] += before[i];
  };
  // The padding, behind the last whole block: 0x80, zeros, the length in bits (8 bytes).
  std::string last(bytes.substr(bytes.size() / 64 * 64));
  last += '\x80';
  while (last.size() % 64 != 56) last += '\0';
  for (int shift = 56; shift >= 0; shift -= 8)
    last += static_cast<char>(std::uint64_t{bytes.size()} * 8 >> shift);
  for (std::size_t at = 0; at + 64 <= bytes.size(); at += 64) digest(bytes.data() + at);
  for (std::size_t at = 0; at < last.size(); at += 64) digest(last.data() + at);

  std::string hex;
  for (const std::uint32_t word : state)
    for (int shift = 28; shift >= 0; shift -= 4) hex += "0123456789abcdef"[word >> shift & 15];
  return hex;
}

}  // namespace verifier
