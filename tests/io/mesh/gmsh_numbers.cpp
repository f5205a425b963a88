// What coordinates of a .msh mean: the nearest double, or the exact decimal value.
#include "reading.hpp"
#include "tiny_mesh.hpp"

#include <catch2/catch.hpp>

#include <cfenv>
#include <limits>
#include <string>
#include <vector>

namespace bezcert::test {
namespace {

// The x of node 2 written as `text`, in both ASCII versions; requires that they agree.
Rational read_x(const std::string& text, Numbers numbers) {
  const ReadOptions options{Basis::lagrange, numbers};
  const Mesh two = read_mesh("2.2", replaced(tiny_22a, "2 1.5 0.25 0", "2 " + text + " 0.25 0"), options);
  const Mesh four = read_mesh("4.1", replaced(tiny_41a, "\n1.5 0.25 0", "\n" + text + " 0.25 0"), options);
  REQUIRE(two.coordinates(0)[1] == four.coordinates(0)[1]);
  CHECK(two.origin().numbers == numbers);
  CHECK(four.origin().numbers == numbers);
  return two.coordinates(0)[1];
}

Rational ten_to_minus(int exponent) { return Rational(1) / power(Rational(10), exponent); }

struct Case {
  std::string text;
  Rational nearest;
  Rational decimal;
};

std::vector<Case> cases() {
  const Rational largest = Rational(std::numeric_limits<double>::max());
  return {
      // 0.1 is 3602879701896397 / 2^55 as a double.
      {"0.1", Rational(3602879701896397) / power_of_two(55), Rational(1, 10)},
      {"1e-1", Rational(3602879701896397) / power_of_two(55), Rational(1, 10)},
      {"-.1E0", -Rational(3602879701896397) / power_of_two(55), Rational(-1, 10)},
      // The double itself, written out: both readings agree.
      {"0.1000000000000000055511151231257827021181583404541015625",
       Rational(3602879701896397) / power_of_two(55), Rational(3602879701896397) / power_of_two(55)},
      // 0.3 is 5404319552844595 / 2^54; the digits behind do not reach the next double.
      {"0.30000000000000000000000000000000000000001", Rational(5404319552844595) / power_of_two(54),
       Rational(3, 10) + ten_to_minus(41)},
      // 2^53 + 1 lies between two doubles: to even.
      {"9007199254740993", Rational(9007199254740992), Rational(9007199254740993)},
      {"9007199254740993.00000000000000000000000000001", Rational(9007199254740994),
       Rational(9007199254740993) + ten_to_minus(29)},
      // 10^22 = 2^22 5^22 with 5^22 < 2^53 is a double.
      {"1e22", power(Rational(10), 22), power(Rational(10), 22)},
      // Half of the least double 2^-1074 is 2.47032822920623272088...e-324.
      {"2.4703282292062327e-324", Rational(0), Rational(24703282292062327) * ten_to_minus(340)},
      {"2.4703282292062328e-324", power_of_two(-1074), Rational(24703282292062328) * ten_to_minus(340)},
      {"1e-400", Rational(0), ten_to_minus(400)},
      {"-1e-400", Rational(0), -ten_to_minus(400)},
      {"1.7976931348623157e308", largest, Rational(17976931348623157) * power(Rational(10), 292)},
      {"-0.0", Rational(0), Rational(0)},
      {"3", Rational(3), Rational(3)},
      {"007.50", Rational(15, 2), Rational(15, 2)},
  };
}

}  // namespace

TEST_CASE("text coordinates mean the nearest double or their decimal value") {
  std::size_t seen = 0;
  for (const Case& one : cases()) {
    INFO("text " << one.text);
    CHECK(read_x(one.text, Numbers::binary64) == one.nearest);
    CHECK(read_x(one.text, Numbers::decimal) == one.decimal);
    ++seen;
  }
  CHECK(seen == 16);
}

TEST_CASE("text of a thousand digits is read to its last one as decimal") {
  const std::string digits = "0." + std::string(999, '3') + "4";
  // 0.33...34 = (10^1000 + 2) / (3 10^1000).
  const Rational scale = power(Rational(10), 1000);
  CHECK(read_x(digits, Numbers::decimal) == (scale + 2) / (3 * scale));
  CHECK(read_x(digits, Numbers::binary64) == Rational(1.0 / 3.0));
}

TEST_CASE("numbers beyond the doubles are refused as doubles and exact as decimals") {
  // Half way from the largest double to 2^1024 is 1.79769313486231580793e308.
  for (const std::string text : {"1.7976931348623159e308", "1e309", "-1e400"}) {
    INFO(text);
    require_refused(replaced(tiny_22a, "2 1.5 0.25 0", "2 " + text + " 0.25 0"), "'" + text + "'", 7);
  }
  CHECK(read_x("-1e400", Numbers::decimal) == -power(Rational(10), 400));
  CHECK(read_x("1e309", Numbers::decimal) == power(Rational(10), 309));
}

TEST_CASE("a mesh read as decimal may mix doubles and others") {
  const std::string text = replaced(tiny_22a, "4 -0.5 0.75 0", "4 -0.1 0.75 0");
  const Mesh mesh = read_mesh("mixed", text, {Basis::lagrange, Numbers::decimal});
  CHECK(mesh.coordinates(0)[0] == 0);
  CHECK(mesh.coordinates(0)[1] == Rational(3, 2));
  CHECK(mesh.coordinates(0)[2] == Rational(5, 4));
  CHECK(mesh.coordinates(0)[3] == Rational(-1, 10));
  CHECK(mesh.coordinates(1)[3] == Rational(3, 4));
  CHECK(mesh.coordinates(1).binary64());
  const auto points = points_of(mesh, 1);
  CHECK(points[2].first == Rational(-1, 10));
  const Element element = mesh.element(1);
  CHECK(element.coordinates()[0][2] == Rational(-1, 10));
  CHECK(element.coordinates()[0][1] == Rational(5, 4));
}

TEST_CASE("binary coordinates are doubles whatever the text of others means") {
  const std::array<std::array<double, 2>, 4> nodes = {{{0, 0}, {0.1, 1e-310}, {0.3, 1e300}, {-0.7, 0.2}}};
  ByteWriter two = binary_start("2.2");
  write_nodes_22b(two, nodes);
  two.text("$Elements\n1\n").int32(2).int32(1).int32(0).int32(1).int32(1).int32(2).int32(3);
  two.text("\n$EndElements\n");
  ByteWriter four = binary_start("4.1");
  write_nodes_41b(four, nodes);
  four.text("$Elements\n").uint64(1).uint64(1).uint64(1).uint64(1).int32(2).int32(1).int32(2).uint64(1);
  four.uint64(1).uint64(1).uint64(2).uint64(3).text("\n$EndElements\n");
  std::size_t seen = 0;
  for (const std::string& bytes : {two.str(), four.str()}) {
    for (const Numbers numbers : {Numbers::binary64, Numbers::decimal}) {
      const Mesh mesh = read_mesh("binary", bytes, {Basis::lagrange, numbers});
      CHECK(mesh.origin().numbers == numbers);
      for (std::size_t k = 0; k < 4; ++k, ++seen) {
        CHECK(mesh.coordinates(0)[k] == Rational(nodes[k][0]));
        CHECK(mesh.coordinates(1)[k] == Rational(nodes[k][1]));
      }
    }
  }
  CHECK(seen == 16);
}

TEST_CASE("reading does not depend on the rounding mode") {
  const int before = std::fegetround();
  std::size_t seen = 0;
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    for (const Case& one : cases()) {
      REQUIRE(std::fesetround(mode) == 0);
      std::optional<Mesh> mesh;
      try {
        mesh = read_mesh("rounding", replaced(tiny_22a, "2 1.5 0.25 0", "2 " + one.text + " 0.25 0"));
      } catch (const InputError& error) {
        std::fesetround(before);
        FAIL(error.what());
      }
      std::fesetround(before);
      INFO("text " << one.text << ", mode " << mode);
      CHECK(mesh->coordinates(0)[1] == one.nearest);
      ++seen;
    }
  }
  CHECK(seen == 48);
}

}  // namespace bezcert::test
