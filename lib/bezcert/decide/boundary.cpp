#include "bezcert/decide/boundary.hpp"

#include "bezcert/curve/separation.hpp"

#include <queue>

namespace bezcert {
namespace {

// Positions in the control net of the control points of an edge, counter-clockwise.
std::vector<std::size_t> edge_indices(Shape shape, int edge) {
  std::vector<std::size_t> result;
  const auto add = [&](int row, int column) { result.push_back(coefficient_index(shape, row, column)); };
  if (shape.domain == Domain::triangle) {
    for (int k = 0; k <= shape.p; ++k) {
      if (edge == 0) add(0, k);
      if (edge == 1) add(k, shape.p - k);
      if (edge == 2) add(shape.p - k, 0);
    }
    return result;
  }
  for (int k = 0; k <= (edge % 2 == 0 ? shape.p : shape.q); ++k) {
    if (edge == 0) add(0, k);
    if (edge == 1) add(k, shape.p);
    if (edge == 2) add(shape.q, shape.p - k);
    if (edge == 3) add(shape.q - k, 0);
  }
  return result;
}

template <class T>
CurveNet<T> edge_net(const Net<T>& net, int edge) {
  CurveNet<T> result;
  for (const std::size_t i : edge_indices(net.shape, edge)) {
    result.x.push_back(net.x[i]);
    result.y.push_back(net.y[i]);
    result.w.push_back(net.rational() ? net.w[i] : T(1));
  }
  return result;
}

class BoundarySearch {
 public:
  explicit BoundarySearch(const Forms& forms) {
    const int edges = forms.element().is_triangle() ? 3 : 4;
    for (int edge = 0; edge < edges; ++edge) {
      std::optional<CurveNet<Interval>> interval;
      if (forms.filter() == Filter::on) interval = edge_net(forms.interval().net, edge);
      curves_.emplace_back(std::move(interval), edge_net(forms.exact().net, edge));
    }
    for (int edge = 0; edge < edges; ++edge) {
      const Place place{edge, DyadicCurve::whole};
      tasks_.push({Relation::same, place, place});
      tasks_.push({Relation::joined, place, {(edge + 1) % edges, DyadicCurve::whole}});
    }
    for (int edge = 0; edge + 2 < edges; ++edge) {
      if (edges == 4)
        tasks_.push({Relation::apart, {edge, DyadicCurve::whole}, {edge + 2, DyadicCurve::whole}});
    }
  }

  BoundaryResult run(const BoundaryBudget& budget) {
    bool too_deep = false;
    for (std::size_t looked = 0; !tasks_.empty(); ++looked) {
      if (looked == budget.pairs) {
        return {BoundaryStatus::open, {}, "boundary pairs " + std::to_string(budget.pairs)};
      }
      const Task task = tasks_.front();
      tasks_.pop();
      if (settled(task)) continue;
      if (task.relation == Relation::apart) {
        if (auto overlap = find_overlap(task)) return {BoundaryStatus::overlapping, std::move(overlap), {}};
      }
      // An overlap may still show elsewhere: the other pairs are looked at all the same.
      if (depth(task.a) >= budget.depth && depth(task.b) >= budget.depth) {
        too_deep = true;
        continue;
      }
      split(task);
    }
    if (too_deep) return {BoundaryStatus::open, {}, "boundary depth " + std::to_string(budget.depth)};
    return {BoundaryStatus::simple, {}, {}};
  }

 private:
  // One piece with itself; two pieces of which the second begins where the first ends; two others.
  enum class Relation { same, joined, apart };
  struct Place {
    int edge = 0;
    DyadicCurve::Piece piece = 0;
  };
  struct Task {
    Relation relation = Relation::apart;
    Place a, b;
  };

  template <class Predicate>
  bool holds(const Place& a, const Place& b, Predicate predicate) {
    return filtered(scope_, curves_[a.edge], a.piece, curves_[b.edge], b.piece, predicate);
  }

  bool settled(const Task& task) {
    switch (task.relation) {
      case Relation::same:
        return holds(task.a, task.b, [](const auto& a, const auto&) { return is_monotone(a); });
      case Relation::joined:
        return holds(task.a, task.b, [](const auto& a, const auto& b) { return part_at_joint(a, b); });
      case Relation::apart: break;
    }
    return holds(task.a, task.b,
                 [](const auto& a, const auto& b) { return side_separates(a, b) || side_separates(b, a); });
  }

  int depth(const Place& place) const { return curves_[place.edge].depth(place.piece); }

  std::optional<Overlap> find_overlap(const Task& task) {
    for (const bool end_of_a : {false, true}) {
      for (const bool end_of_b : {false, true}) {
        const bool meet = holds(task.a, task.b, [&](const auto& a, const auto& b) {
          return ends_meet(a, end_of_a ? a.size() - 1 : 0, b, end_of_b ? b.size() - 1 : 0);
        });
        if (meet) return Overlap{end(task.a, end_of_a), end(task.b, end_of_b)};
      }
    }
    const bool cross = holds(task.a, task.b, [](const auto& a, const auto& b) {
      return certainly_crosses(a, b) || certainly_crosses(b, a);
    });
    if (!cross) return std::nullopt;
    return Overlap{range(task.a), range(task.b)};
  }

  BoundaryRange range(const Place& place) const {
    const DyadicCurve& curve = curves_[place.edge];
    return {place.edge, curve.lower(place.piece), curve.upper(place.piece)};
  }
  BoundaryRange end(const Place& place, bool last) const {
    const BoundaryRange whole = range(place);
    const Rational& at = last ? whole.upper : whole.lower;
    return {place.edge, at, at};
  }

  std::pair<Place, Place> halves(const Place& place) {
    const auto [first, second] = curves_[place.edge].halves(place.piece);
    return {{place.edge, first}, {place.edge, second}};
  }

  void split(const Task& task) {
    const auto [a1, a2] = halves(task.a);
    if (task.relation == Relation::same) {
      tasks_.push({Relation::same, a1, a1});
      tasks_.push({Relation::same, a2, a2});
      tasks_.push({Relation::joined, a1, a2});
      return;
    }
    if (task.relation == Relation::joined) {
      const auto [b1, b2] = halves(task.b);
      tasks_.push({Relation::joined, a2, b1});
      tasks_.push({Relation::apart, a1, b1});
      tasks_.push({Relation::apart, a1, b2});
      tasks_.push({Relation::apart, a2, b2});
      return;
    }
    // The longer piece in parameters; pieces of different lengths make crossings show.
    if (curves_[task.a.edge].depth(task.a.piece) <= curves_[task.b.edge].depth(task.b.piece)) {
      tasks_.push({Relation::apart, a1, task.b});
      tasks_.push({Relation::apart, a2, task.b});
    } else {
      const auto [b1, b2] = halves(task.b);
      tasks_.push({Relation::apart, task.a, b1});
      tasks_.push({Relation::apart, task.a, b2});
    }
  }

  RoundingScope scope_;
  std::deque<DyadicCurve> curves_;
  std::queue<Task> tasks_;
};

}  // namespace

BoundaryResult examine_boundary(const Forms& forms, const BoundaryBudget& budget) {
  const RoundingScope scope;
  return BoundarySearch(forms).run(budget);
}

Parameter boundary_parameter(const Element& element, int edge, const Rational& t) {
  const Rational s = 1 - t;
  if (element.is_triangle()) {
    Parameter result(3);
    result[edge] = s;
    result[(edge + 1) % 3] = t;
    return result;
  }
  switch (edge) {
    case 0: return {t, 0};
    case 1: return {1, t};
    case 2: return {s, 1};
    default: return {0, s};
  }
}

}  // namespace bezcert
