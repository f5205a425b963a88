// What the verifier says of a text.
#pragma once

#include "text.hpp"

#include <string>

namespace bezcert::test {

/// Empty if `check` accepts all of the text, else why not.
template <class Check>
std::string refusal_of(const std::string& text, Check check) {
  verifier::begin_line();
  try {
    verifier::Tokens tokens(text);
    check(tokens);
    tokens.expect_end();
  } catch (const verifier::Rejected& rejected) {
    return "rejected: " + rejected.why;
  } catch (const verifier::Malformed& malformed) {
    return "malformed: " + malformed.why;
  }
  return "";
}

}  // namespace bezcert::test
