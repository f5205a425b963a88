// Evidence that curves meet, checked by the verifier, which was written from the specification alone.
#include "bezcert/certificate/meet_evidence.hpp"
#include "bezcert/decide/decide.hpp"
#include "bezcert/element/forms.hpp"
#include "bezcert/io/file.hpp"
#include "bezcert/io/mesh/read.hpp"
#include "rules.hpp"
#include "verified_curves.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <map>

using namespace bezcert;
using namespace bezcert::test;

namespace {

std::string accepted(const CurveNet<Integer>& a, const CurveNet<Integer>& b, Joints joints = {}) {
  DyadicCurve curve_a = dyadic(a, true), curve_b = dyadic(b, true);
  const ContactResult found = find_contact(curve_a, curve_b, joints);
  REQUIRE(found.contact);
  const CommonPlaces common{false, {{false, joints.begin_to_end}, {joints.end_to_begin, false}}};
  const auto text = meet_evidence({a, "0"}, {b, "1"}, common, *found.contact);
  REQUIRE(text);
  CHECK(refusal_of_meet(*text, a, b, common) == "");
  return *text;
}

}  // namespace

TEST_CASE("meeting at a point, crossing, touching") {
  const auto axis = net_of({{-1, 0}, {2, 0}});
  CHECK(accepted(axis, net_of({{0, 0}, {0, 1}})) == "at 0 1/3 1 0");
  CHECK(accepted(axis, net_of({{Rational(1, 7), -1}, {Rational(1, 5), 1}})).starts_with("cross "));
  // y = (2 x^2 - 1)^2 touches the axis at x = 1/sqrt(2).
  const auto quartic =
      net_of({{0, 1}, {Rational(1, 4), 1}, {Rational(1, 2), Rational(1, 3)}, {Rational(3, 4), -1}, {1, 1}});
  CHECK(accepted(axis, quartic).starts_with("root "));
  CHECK(accepted(quartic, axis).starts_with("root "));
}

TEST_CASE("touching at an irrational point beside a joint") {
  // From (0, 0), y = (2 x^2 - 1)^2 x and the axis back to it.
  const Rational fifth(1, 5);
  const auto axis = net_of({{2, 0}, {0, 0}});
  // Bernstein coefficients of x - 4 x^3 + 4 x^5.
  const auto quintic = net_of({{0, 0},
                               {fifth, fifth},
                               {2 * fifth, 2 * fifth},
                               {3 * fifth, Rational(1, 5)},
                               {4 * fifth, Rational(-4, 5)},
                               {1, 1}});
  CHECK(accepted(axis, quintic, {true, false}).starts_with("root "));
}

TEST_CASE("a piece in common") {
  // Two parts of one parabola.
  const auto a = net_of({{0, 0}, {1, 0}, {2, 4}}), b = net_of({{1, 1}, {2, 3}, {3, 9}});
  const std::string text = accepted(a, b);
  CHECK(text.starts_with("at "));
}

TEST_CASE("the corpus has evidence for every overlapping element") {
  std::map<std::string, int> kinds;
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(BEZCERT_SOURCE_DIR "/corpus/elements")) {
    const std::string file = entry.path().string(), bytes = read_file(file);
    INFO(file);
    const Mesh mesh = read_mesh(file, bytes);
    const Element element = mesh.element(0);
    const Forms forms(element), exact(element, Filter::off);
    const Decision decision = decide(forms);
    if (decision.verdict != ElementVerdict::overlapping) continue;
    ++count;
    const auto text = meet_evidence(forms, *decision.overlap);
    REQUIRE(text);
    CHECK(meet_evidence(exact, *decision.overlap) == text);
    ++kinds[text->substr(0, text->find(' '))];
    const verifier::Elements elements(bytes, "mixed", "decimal");
    const std::vector<verifier::Curve> edges = verifier::edge_curves(elements.element(0));
    CHECK(refusal_of(*text, [&](verifier::Tokens& tokens) {
            verifier::check_meet(tokens, false, [&](const auto& first, const auto& second) {
              const auto i = static_cast<std::size_t>(first.edge), j = static_cast<std::size_t>(second.edge);
              verifier::MeetingEdges meeting{edges.at(i), edges.at(j), i == j, {}};
              meeting.common[1][0] = (i + 1) % edges.size() == j;
              meeting.common[0][1] = (j + 1) % edges.size() == i;
              return meeting;
            });
          }) == "");
  }
  CHECK(count >= 17);
  for (const char* kind : {"at", "cross", "root"}) CHECK(kinds[kind] > 0);
}
