// A mesh's decisions are those of its elements alone, with and without filters, in every part that a report
// shows.
#include "batch/hostile_mesh.hpp"
#include "bezcert/element/forms.hpp"
#include "bezcert/report/decision_text.hpp"

#include <catch2/catch.hpp>

using namespace bezcert;
using namespace bezcert::test;

namespace {

std::string text(const Dyadic& d) { return std::to_string(d.mantissa) + "*2^" + std::to_string(d.exponent); }

std::string text(const std::optional<Witness>& witness) {
  if (!witness) return "-";
  std::string result;
  for (const Rational& p : witness->parameter.values()) result += to_string(p) + " ";
  return result + to_string(witness->determinant);
}

std::string text(const Decision& d) {
  return std::string(name(d.verdict)) + ", witness " + text(d.witness) + ", other " + text(d.other_witness) +
         ", bounds " + text(d.bounds.min_lower) + " " + text(d.bounds.min_upper) + " " +
         text(d.bounds.max_lower) + " " + text(d.bounds.max_upper) + ", sign " +
         std::string(name(d.sign_proof)) + ", injective by " + std::string(name(d.injectivity_proof)) +
         ", open " + open_text(d) + ", pieces " + std::to_string(d.pieces);
}

Budget small_budget() {
  Budget budget;
  budget.pieces = 40;
  budget.algebra_bits = 0;
  budget.contact.pairs = 40;
  budget.contact.algebra_bits = 0;
  return budget;
}

std::vector<std::string> decisions(const Mesh& mesh, Filter filter, DecisionCounts& counts) {
  std::vector<std::string> result;
  counts = MeshDecider(mesh, small_budget(), filter)
               .decide_range(0, mesh.elements().size(), [&](std::size_t i, const Decision& decision) {
                 REQUIRE(i == result.size());
                 result.push_back(text(decision));
               });
  return result;
}

Mesh hostile_mesh(Random& random, std::size_t count, bool weights) {
  MeshParts mesh;
  while (mesh.elements.size() < count) {
    DoubleNet net = hostile_net(random);
    if (!weights && !net.w.empty()) continue;
    // Polynomial elements of a mesh with weights have equal ones.
    if (weights && net.w.empty()) net.w.assign(net.x.size(), 1.25);
    append(mesh, net);
  }
  return mesh.build();
}

}  // namespace

TEST_CASE("MeshDecider gives the decision of every element alone, with filters on and off") {
  const std::uint64_t seed = seed_or(510);
  Random random(seed);
  DecisionCounts total;
  for (const bool weights : {false, true}) {
    for (int round = 0; round < 4; ++round) {
      const Mesh mesh = hostile_mesh(random, 700, weights);
      DecisionCounts on, off;
      const auto with_filters = decisions(mesh, Filter::on, on);
      const auto exact = decisions(mesh, Filter::off, off);
      REQUIRE(with_filters.size() == mesh.elements().size());
      for (std::size_t i = 0; i < mesh.elements().size(); ++i) {
        INFO("seed " << seed << ", weights " << weights << ", round " << round << ", element " << i);
        REQUIRE(with_filters[i] == exact[i]);
        const Element element = mesh.element(i);
        REQUIRE(with_filters[i] == text(decide(Forms(element), small_budget())));
      }
      REQUIRE(off.exact == mesh.elements().size());
      REQUIRE(on.batch + on.interval + on.exact == mesh.elements().size());
      total.batch += on.batch;
      total.interval += on.interval;
      total.exact += on.exact;
    }
  }
  INFO("seed " << seed << ": " << total.batch << " by blocks, " << total.interval << " by intervals, "
               << total.exact << " exactly");
  CHECK(total.batch > 1000);
  CHECK(total.interval > 500);
  CHECK(total.exact > 200);
}

TEST_CASE("MeshDecider decides a part of a mesh as the whole, whatever the window") {
  const std::uint64_t seed = seed_or(511);
  Random random(seed);
  const Mesh mesh = hostile_mesh(random, 600, false);
  DecisionCounts counts;
  const auto whole = decisions(mesh, Filter::on, counts);
  const std::size_t size = mesh.elements().size();
  for (const auto& [first, last] :
       {std::pair<std::size_t, std::size_t>{0, 0}, {0, 1}, {5, 21}, {250, 520}, {599, size}}) {
    std::size_t at = first;
    MeshDecider(mesh, small_budget()).decide_range(first, last, [&](std::size_t i, const Decision& decision) {
      REQUIRE(i == at++);
      REQUIRE(text(decision) == whole[i]);
    });
    REQUIRE(at == last);
  }
}

TEST_CASE("no mesh can be made of what an element refuses") {
  DoubleNet net{Shape::triangle(1), Basis::bernstein, {0, 1, 0}, {0, 0, 1}, {1, -1, 2}};
  CHECK_THROWS_AS(mesh_of(net), std::invalid_argument);
}
