// Places of lines against a plain search, for texts around the sizes of pieces and vectors.
#include "bezcert/io/line_starts.hpp"
#include "random_input.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>

namespace bezcert::test {

TEST_CASE("lines begin where a plain search says") {
  const std::uint64_t seed = seed_or(611);
  Random random(seed);
  std::size_t lines = 0, empty = 0, turned = 0;
  for (int i = 0; i < 400; ++i) {
    // Around the sizes of pieces, and of the ranges of pieces that are looked at in one go.
    const auto near = random.chance(10) ? random.integer(1, 3) * 64 * 4096 + random.integer(-20, 20)
                                        : random.integer(0, 3) * 4096 + random.integer(-20, 20);
    std::string text(static_cast<std::size_t>(random.chance(20) ? random.integer(0, 60) : std::max(near, 0L)),
                     'x');
    const int percent = static_cast<int>(random.integer(0, 100));
    // Bytes that differ from '\n' by their top bit too.
    for (char& c : text) c = random.chance(percent) ? '\n' : static_cast<char>(random.integer(-128, 127));
    INFO("seed " << seed << " case " << i << ", " << text.size() << " bytes");
    // Pieces in another order than theirs.
    const Parallel backwards = [&](std::size_t count, const std::function<void(std::size_t)>& work) {
      if (count > 1) ++turned;
      for (std::size_t k = count; k-- > 0;) work(k);
    };
    const LineStarts starts(text, random.chance(50) ? backwards : Parallel());
    REQUIRE(starts.ends() == static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')));
    std::size_t at = 0;
    for (std::size_t line = 0; line <= starts.ends(); ++line) {
      REQUIRE(starts.start(line) == at);
      at = text.find('\n', at) + 1;
    }
    lines += starts.ends();
    if (starts.ends() == 0) ++empty;
  }
  CHECK(lines > 500000);
  CHECK(empty > 3);
  CHECK(turned > 8);
  CHECK(LineStarts("", {}).ends() == 0);
}

}  // namespace bezcert::test
