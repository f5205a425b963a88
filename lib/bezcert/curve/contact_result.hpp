// What the search for a contact of two curves (contact.hpp) says.
#pragma once

#include "bezcert/number/rational.hpp"

#include <cstddef>
#include <optional>

namespace bezcert {

/// Parameters of a curve from lower to upper; one parameter, known exactly, where they are equal.
struct ParameterRange {
  Rational lower, upper;
};

/// Parameters (or ranges that hold one each) where the curves have a common point.
struct Contact {
  ParameterRange first, second;
  /// Whether the curves have a whole piece in common there; known where algebra found the contact, false
  /// where two dyadic points or a crossing did.
  bool along_a_piece = false;
};

/// A resultant that algebra was not asked about: its bits are more than the budget allows.
struct ExceededBits {
  std::size_t allowed = 0, needed = 0;
};

enum class ContactStatus { none, contact, open };

struct ContactResult {
  ContactStatus status = ContactStatus::open;
  std::optional<Contact> contact;        ///< set if contact
  std::optional<ExceededBits> exceeded;  ///< set if open
};

}  // namespace bezcert
