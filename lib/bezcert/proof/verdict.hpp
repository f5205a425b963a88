// What a criterion or the decision says of one element, and the evidence it shows.
#pragma once

#include "bezcert/element/element.hpp"
#include "bezcert/element/jacobian_tree.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace bezcert {

/// What a proof would prove: det J > 0 on the closed element, or that and that the map is injective.
enum class Claim { regular, injective };

/// The outcome of a criterion. A sufficient condition that fails is `inconclusive`; only a witness refutes.
enum class Status { proved, refuted, inconclusive, not_applicable };

/// A parameter and the exact value of det J there.
struct Witness {
  Parameter parameter;
  Rational determinant;
};

/// Evaluates det J at a parameter directly (evaluate_map): the witness stands on its own.
Witness make_witness(const Element& element, Parameter parameter);

struct Verdict {
  std::string_view criterion;
  Claim claim = Claim::regular;
  Status status = Status::inconclusive;
  /// Which condition failed, or why the criterion does not apply; empty if proved.
  std::string reason;
  /// Set if refuted: det J <= 0 there.
  std::optional<Witness> witness;
  /// Set by criteria that bound det J.
  std::optional<DeterminantBounds> bounds;
};

std::string_view name(Claim claim);
std::string_view name(Status status);

}  // namespace bezcert
