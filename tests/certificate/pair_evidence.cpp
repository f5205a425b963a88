// Evidence that curves do not meet, checked by the verifier, which was written from the specification alone.
#include "bezcert/certificate/pair_evidence.hpp"
#include "bezcert/curve/same_curve.hpp"
#include "bezcert/decide/decide.hpp"
#include "bezcert/element/forms.hpp"
#include "bezcert/io/file.hpp"
#include "bezcert/io/mesh/read.hpp"
#include "random_input.hpp"
#include "verified_curves.hpp"

#include <catch2/catch.hpp>

#include <filesystem>

using namespace bezcert;
using namespace bezcert::test;

namespace {

// Accepted by the verifier, and the same without filter.
std::string accepted(const CurveNet<Integer>& a, const CurveNet<Integer>& b, Joints joints) {
  DyadicCurve filtered_a = dyadic(a, true), filtered_b = dyadic(b, true);
  DyadicCurve exact_a = dyadic(a, false), exact_b = dyadic(b, false);
  const auto text = pair_evidence(filtered_a, filtered_b, joints);
  REQUIRE(text);
  CHECK(refusal_of_pair(*text, a, b, joints) == "");
  CHECK(pair_evidence(exact_a, exact_b, joints) == text);
  return *text;
}

const Rational tiny(Integer(1), Integer("1000000000000"));

}  // namespace

TEST_CASE("lines part straight edges") {
  const auto a = net_of({{0, 0}, {1, 0}}), b = net_of({{0, 1}, {1, 1}}), c = net_of({{1, 0}, {1, 1}});
  CHECK(accepted(a, b, {}) == "s 0 1");
  CHECK(accepted(b, a, {}) == "s 0 -1");
  CHECK(accepted(a, c, {true, false}) == "j 1 1");
  CHECK(accepted(reversed(a), reversed(c), {false, true}) == "j 1 1");
  // A wedge of 1e-12: n must be known to as many digits.
  const auto wedge = net_of({{1, 0}, {0, tiny}});
  CHECK(accepted(a, wedge, {true, false}).starts_with("j "));
}

TEST_CASE("edges of two joints are halved") {
  // A closed lens of two parabolas.
  const auto a = net_of({{0, 0}, {1, -1}, {2, 0}}), b = net_of({{2, 0}, {1, 1}, {0, 0}});
  CHECK(accepted(a, b, {true, true}).starts_with("a "));
}

TEST_CASE("cusps on two sides of the tangent are parted by it, on one side by a resultant") {
  // From (0, 0) along y = x^2 and y = -x^2, y = x^2 and y = 2 x^2, and y = 0.
  const auto up = net_of({{0, 0}, {Rational(1, 2), 0}, {1, 1}});
  const auto steep = net_of({{0, 0}, {Rational(1, 2), 0}, {1, 2}});
  const auto down = net_of({{0, 0}, {Rational(1, 2), 0}, {1, -1}});
  CHECK(accepted(reversed(up), down, {true, false}) == "j 0 -1");
  CHECK(accepted(reversed(up), steep, {true, false}) == "r");
  CHECK(accepted(up, reversed(steep), {false, true}) == "r");
  // A quintic beside it, so near that only the fifth power differs.
  const auto quintic = net_of({{0, 0},
                               {Rational(1, 5), 0},
                               {Rational(2, 5), Rational(1, 10)},
                               {Rational(3, 5), Rational(3, 10)},
                               {Rational(4, 5), Rational(3, 5)},
                               {1, 2}});  // y = x^2 + x^5
  CHECK(accepted(reversed(up), quintic, {true, false}) == "r");
}

TEST_CASE("a resultant parts curves that run along each other very near") {
  // Quarters of circles of radius 1 and 1 - 1e-12: lines alone would take a million pieces.
  const Rational r = 1 - tiny;
  const auto outer = net_of({{1, 0}, {1, 1}, {0, 1}}, {1, 1, 2}),
             inner = net_of({{r, 0}, {r, r}, {0, r}}, {1, 1, 2});
  CHECK(accepted(outer, inner, {}).find('r') != std::string::npos);
}

TEST_CASE("curves that meet have no evidence that they do not") {
  const auto a = net_of({{-1, 0}, {1, 0}});
  const auto crossing = net_of({{0, -1}, {0, 1}}), touching = net_of({{-1, 1}, {0, -1}, {1, 1}});
  for (const auto& other : {crossing, touching, a}) {
    for (const bool filter : {true, false}) {
      DyadicCurve first = dyadic(a, filter), second = dyadic(other, filter);
      CHECK_FALSE(pair_evidence(first, second, {}));
    }
  }
  // The joint is not named.
  DyadicCurve first = dyadic(a, true), next = dyadic(net_of({{1, 0}, {1, 1}}), true);
  CHECK_FALSE(pair_evidence(first, next, {}));
  // A loop.
  DyadicCurve loop = dyadic(net_of({{0, 0}, {4, 2}, {-3, 2}, {1, 0}}), true);
  CHECK_FALSE(self_evidence(loop));
}

TEST_CASE("random pairs of curves that do not meet have evidence") {
  const std::uint64_t seed = seed_or(20261122);
  Random random(seed);
  int apart = 0, joined = 0, meeting = 0;
  for (int k = 0; k < 400; ++k) {
    INFO("seed " << seed << " case " << k);
    const bool joint = random.chance(50);
    const auto some = [&](std::optional<std::array<Rational, 2>> first) {
      std::vector<std::array<Rational, 2>> points;
      std::vector<Rational> weights;
      const long degree = random.integer(1, 4);
      Rational x = first ? (*first)[0] : random.rational(-4, 4, 8),
               y = first ? (*first)[1] : random.rational(-4, 4, 8);
      const bool rational = random.chance(30);
      const long dx = random.integer(-3, 3);
      for (long i = 0; i <= degree; ++i) {
        points.push_back({x, y});
        weights.push_back(rational ? random.rational(1, 3, 2) : Rational(1));
        x += dx + random.rational(-1, 1, 16);
        y += random.rational(-2, 2, 16) + Rational(1, 64);
      }
      return net_of(points, weights);
    };
    CurveNet<Integer> a = some(std::nullopt);
    const std::size_t last = a.size() - 1;
    const auto end = std::array<Rational, 2>{Rational(a.x[last], a.w[last]), Rational(a.y[last], a.w[last])};
    const CurveNet<Integer> b = joint ? some(end) : some(std::nullopt);
    DyadicCurve curve_a = dyadic(a, true), curve_b = dyadic(b, true);
    // The rule `r` and the decision ask for injective curves.
    if (!self_evidence(curve_a) || !self_evidence(curve_b)) continue;
    const ContactResult contact = find_contact(curve_a, curve_b, {joint, false});
    if (contact.status == ContactStatus::contact) {
      ++meeting;
      CHECK_FALSE(pair_evidence(curve_a, curve_b, {joint, false}));
      const CommonPlaces common{false, {{false, false}, {joint, false}}};
      const auto meet = meet_evidence({a, "0"}, {b, "1"}, common, *contact.contact);
      REQUIRE(meet);
      CHECK(refusal_of_meet(*meet, a, b, common) == "");
      continue;
    }
    ++(joint ? joined : apart);
    accepted(a, b, {joint, false});
  }
  CHECK(apart > 60);
  CHECK(joined > 60);
  CHECK(meeting > 20);
}

TEST_CASE("the corpus has evidence for every simple boundary") {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(BEZCERT_SOURCE_DIR "/corpus/elements")) {
    const std::string file = entry.path().string(), bytes = read_file(file);
    INFO(file);
    const Mesh mesh = read_mesh(file, bytes);
    const Element element = mesh.element(0);
    const Forms forms(element), exact(element, Filter::off);
    const Decision decision = decide(forms);
    if (decision.verdict != ElementVerdict::injective ||
        decision.injectivity_proof != InjectivityProof::boundary)
      continue;
    ++count;
    const auto text = boundary_evidence(forms);
    REQUIRE(text);
    CHECK(boundary_evidence(exact) == text);
    CHECK(text->size() < 4096);
    const verifier::Elements elements(bytes, "mixed", "decimal");
    CHECK(refusal_of(*text, [&](verifier::Tokens& tokens) {
            CHECK(tokens.accept("boundary"));
            verifier::check_boundary(tokens, verifier::edge_curves(elements.element(0)));
          }) == "");
  }
  CHECK(count > 50);
}
