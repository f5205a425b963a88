// SHA-256 (FIPS 180-4). Its constants: the first 32 bits of the fractions of roots of the first primes.
#include "elements.hpp"

#include <array>
#include <bit>
#include <cstdint>

namespace verifier {

std::string sha256(std::string_view bytes) {
  std::array<std::uint32_t, 64> constants;
  std::array<std::uint32_t, 8> state;
  mpz_class prime = 1;
  for (std::size_t i = 0; i < 64; ++i) {
    mpz_nextprime(prime.get_mpz_t(), prime.get_mpz_t());
    const auto root_bits = [&](unsigned root) {
      mpz_class r = prime << (32 * root);
      mpz_root(r.get_mpz_t(), r.get_mpz_t(), root);
      return static_cast<std::uint32_t>(r.get_ui());
    };
    constants[i] = root_bits(3);
    if (i < 8) state[i] = root_bits(2);
  }
  // The padding, behind the last whole block: 0x80, zeros, the length in bits (8 bytes).
  const std::size_t whole = bytes.size() / 64 * 64;
  std::string last(bytes.substr(whole));
  last += '\x80';
  while (last.size() % 64 != 56) last += '\0';
  for (int shift = 56; shift >= 0; shift -= 8)
    last += static_cast<char>(std::uint64_t{bytes.size()} * 8 >> shift);

  for (std::string_view blocks : {bytes.substr(0, whole), std::string_view(last)})
    for (; !blocks.empty(); blocks.remove_prefix(64)) {
      std::array<std::uint32_t, 64> w{};
      for (std::size_t i = 0; i < 64; ++i) w[i / 4] = w[i / 4] << 8 | static_cast<unsigned char>(blocks[i]);
      for (std::size_t i = 16; i < 64; ++i) {
        const std::uint32_t x = w[i - 15], y = w[i - 2];
        w[i] = w[i - 16] + w[i - 7] + (std::rotr(x, 7) ^ std::rotr(x, 18) ^ x >> 3) +
               (std::rotr(y, 17) ^ std::rotr(y, 19) ^ y >> 10);
      }
      const std::array<std::uint32_t, 8> before = state;
#pragma GCC unroll 8  // so that the words stay where they are
      for (std::size_t i = 0; i < 64; ++i) {
        const auto [a, b, c, d, e, f, g, h] = state;
        const std::uint32_t s = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
        const std::uint32_t r = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
        const std::uint32_t t = h + s + ((e & f) ^ (~e & g)) + constants[i] + w[i];
        state = {t + r + ((a & b) ^ (a & c) ^ (b & c)), a, b, c, d + t, e, f, g};
      }
      for (std::size_t i = 0; i < 8; ++i) state[i] += before[i];
    }

  std::string hex;
  for (const std::uint32_t word : state)
    for (int shift = 28; shift >= 0; shift -= 4) hex += "0123456789abcdef"[word >> shift & 15];
  return hex;
}

}  // namespace verifier
