#include "bezcert/curve/contact.hpp"

#include "bezcert/curve/contact_algebra.hpp"
#include "bezcert/curve/separation.hpp"

#include <deque>
#include <vector>

namespace bezcert {
namespace {

// Dyadic subdivision of one curve with itself or of two.
class Search {
 public:
  Search(DyadicCurve& a, DyadicCurve& b, const ContactBudget& budget) : a_(a), b_(b), budget_(budget) {}

  ContactResult run(Joints joints, bool itself) {
    constexpr Piece whole = DyadicCurve::whole;
    if (itself) {
      near_.push_back({Relation::same, whole, whole});
    } else if (joints.end_to_begin && joints.begin_to_end) {
      near_.push_back({Relation::ring, whole, whole});
    } else if (joints.end_to_begin) {
      near_.push_back({Relation::joined, whole, whole});
    } else if (joints.begin_to_end) {
      near_.push_back({Relation::joined_back, whole, whole});
    } else {
      apart_.push_back({Relation::apart, whole, whole});
    }
    std::vector<Task> open;
    // Neighbours first: they end by themselves unless the curves are tangent at the joint, and leave pairs
    // without a common parameter.
    for (std::size_t looked = 0; !near_.empty(); ++looked) {
      const Task task = near_.front();
      near_.pop_front();
      if (settled(task)) continue;
      if (looked >= budget_.pairs || a_.depth(task.a) >= budget_.depth) {
        open.push_back(task);
      } else {
        split_near(task);
      }
    }
    for (std::size_t looked = 0; !apart_.empty(); ++looked) {
      const Task task = apart_.front();
      apart_.pop_front();
      if (settled(task)) continue;
      if (auto contact = certain_contact(task)) return {ContactStatus::contact, std::move(contact), {}};
      // Contacts may still show elsewhere: the other pairs are looked at all the same.
      if (looked >= budget_.pairs ||
          (a_.depth(task.a) >= budget_.depth && b_.depth(task.b) >= budget_.depth)) {
        open.push_back(task);
      } else {
        split_apart(task);
      }
    }
    if (open.empty()) return {ContactStatus::none, {}, {}};
    return by_algebra(open, joints, itself);
  }

 private:
  using Piece = DyadicCurve::Piece;
  // One piece with itself; b begins where a ends; b ends where a begins; both; no common parameter.
  enum class Relation { same, joined, joined_back, ring, apart };
  struct Task {
    Relation relation = Relation::apart;
    Piece a = 0, b = 0;
  };

  template <class Predicate>
  bool holds(Piece a, Piece b, Predicate predicate) {
    return filtered(a_, a, b_, b, predicate);
  }

  bool settled(const Task& task) {
    switch (task.relation) {
      case Relation::same:
        return holds(task.a, task.a, [](const auto& a, const auto&) { return is_monotone(a); });
      case Relation::joined:
        return holds(task.a, task.b, [](const auto& a, const auto& b) { return part_at_joint(a, b); });
      case Relation::joined_back:
        return holds(task.a, task.b, [](const auto& a, const auto& b) { return part_at_joint(b, a); });
      case Relation::ring: return false;
      case Relation::apart: break;
    }
    return holds(task.a, task.b,
                 [](const auto& a, const auto& b) { return side_separates(a, b) || side_separates(b, a); });
  }

  void split_near(const Task& task) {
    const auto [a1, a2] = a_.halves(task.a);
    if (task.relation == Relation::same) {
      near_.push_back({Relation::same, a1, a1});
      near_.push_back({Relation::same, a2, a2});
      near_.push_back({Relation::joined, a1, a2});
      return;
    }
    const auto [b1, b2] = b_.halves(task.b);
    const bool end = task.relation != Relation::joined_back, begin = task.relation != Relation::joined;
    if (end) near_.push_back({Relation::joined, a2, b1});
    if (begin) near_.push_back({Relation::joined_back, a1, b2});
    if (!end) apart_.push_back({Relation::apart, a2, b1});
    if (!begin) apart_.push_back({Relation::apart, a1, b2});
    apart_.push_back({Relation::apart, a1, b1});
    apart_.push_back({Relation::apart, a2, b2});
  }

  void split_apart(const Task& task) {
    // The longer piece in parameters; pieces of different lengths make crossings show.
    if (a_.depth(task.a) <= b_.depth(task.b)) {
      const auto [a1, a2] = a_.halves(task.a);
      apart_.push_back({Relation::apart, a1, task.b});
      apart_.push_back({Relation::apart, a2, task.b});
    } else {
      const auto [b1, b2] = b_.halves(task.b);
      apart_.push_back({Relation::apart, task.a, b1});
      apart_.push_back({Relation::apart, task.a, b2});
    }
  }

  bool cross(Piece a, Piece b) {
    return holds(a, b, [](const auto& x, const auto& y) {
      return certainly_crosses(x, y) || certainly_crosses(y, x);
    });
  }

  std::optional<Contact> certain_contact(const Task& task) {
    for (const bool end_of_a : {false, true}) {
      for (const bool end_of_b : {false, true}) {
        const bool meet = holds(task.a, task.b, [&](const auto& a, const auto& b) {
          return ends_meet(a, end_of_a ? a.size() - 1 : 0, b, end_of_b ? b.size() - 1 : 0);
        });
        if (!meet) continue;
        const Rational s = end_of_a ? a_.upper(task.a) : a_.lower(task.a);
        const Rational t = end_of_b ? b_.upper(task.b) : b_.lower(task.b);
        return Contact{{s, s}, {t, t}, false};
      }
    }
    if (!cross(task.a, task.b)) return std::nullopt;
    // Narrower ranges, as long as halves certainly cross.
    Piece a = task.a, b = task.b;
    for (bool narrower = true; narrower;) {
      narrower = false;
      std::vector<Piece> parts_a = {a}, parts_b = {b};
      constexpr int fine = 20;
      if (a_.depth(a) < fine) {
        const auto [first, second] = a_.halves(a);
        parts_a = {first, second, a};
      }
      if (b_.depth(b) < fine) {
        const auto [first, second] = b_.halves(b);
        parts_b = {first, second, b};
      }
      for (std::size_t i = 0; i < parts_a.size() && !narrower; ++i) {
        for (std::size_t j = 0; j < parts_b.size() && !narrower; ++j) {
          if (parts_a[i] == a && parts_b[j] == b) continue;
          if (!cross(parts_a[i], parts_b[j])) continue;
          narrower = true;
          a = parts_a[i];
          b = parts_b[j];
        }
      }
    }
    return Contact{{a_.lower(a), a_.upper(a)}, {b_.lower(b), b_.upper(b)}, false};
  }

  ContactResult by_algebra(const std::vector<Task>& open, Joints joints, bool itself) {
    Strips strips_s, strips_t;
    for (const Task& task : open) {
      strips_s.emplace_back(a_.lower(task.a), a_.upper(task.a));
      strips_t.emplace_back(b_.lower(task.b), b_.upper(task.b));
    }
    AlgebraicContact found =
        contact_by_algebra(a_.exact(DyadicCurve::whole), b_.exact(DyadicCurve::whole), itself, joints,
                           merged(std::move(strips_s)), merged(std::move(strips_t)), budget_.algebra_bits);
    if (found.exceeded) return {ContactStatus::open, {}, found.exceeded};
    if (found.contact) return {ContactStatus::contact, std::move(found.contact), {}};
    return {ContactStatus::none, {}, {}};
  }

  DyadicCurve& a_;
  DyadicCurve& b_;
  const ContactBudget& budget_;
  std::deque<Task> near_, apart_;
};

}  // namespace

ContactResult self_contact(DyadicCurve& curve, const ContactBudget& budget) {
  return Search(curve, curve, budget).run({}, true);
}

ContactResult find_contact(DyadicCurve& a, DyadicCurve& b, Joints joints, const ContactBudget& budget) {
  return Search(a, b, budget).run(joints, false);
}

}  // namespace bezcert
