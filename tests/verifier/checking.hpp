// The verifier inside a test: main.cpp's loop over a certificate, on bytes instead of files. Its answers are
// compared with the program's by example_test.
#pragma once

#include "rules.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace bezcert::test {

struct Judgement {
  int code = 0;  ///< 0 accepted, 1 rejected, 2 malformed
  std::size_t line = 0;
  std::string why;
  std::vector<verifier::Claim> claims;  ///< if accepted
  std::string mesh;
};

class Judge {
 public:
  Judge(const std::string& elements, std::string_view certificate)
      : elements_(elements), rest_(certificate) {}

  Judgement operator()() {
    Judgement result;
    try {
      check(result);
      return result;
    } catch (const verifier::Rejected& error) {
      return {1, line_, error.why, {}, ""};
    } catch (const verifier::Malformed& error) {
      return {2, line_, error.why, {}, ""};
    } catch (const std::exception& error) {  // as main.cpp
      return {2, line_, std::string("limit: ") + error.what(), {}, ""};
    }
  }

 private:
  std::string_view next() {
    verifier::begin_line();
    ++line_;
    const std::size_t end = rest_.find('\n');
    if (end == rest_.npos) throw verifier::Malformed{"the certificate ends too early"};
    current_ = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    return current_;
  }

  std::string word_of(std::string_view key) {
    verifier::Tokens tokens(next());
    if (!tokens.accept(key)) throw verifier::Malformed{"expected " + std::string(key)};
    const std::string word(tokens.word());
    tokens.expect_end();
    return word;
  }

  void check(Judgement& result) {
    if (word_of("bezcert-certificate") != "1") throw verifier::Malformed{"version"};
    const std::string hash = word_of("elements");
    if (hash.size() != 64 || hash.find_first_not_of("0123456789abcdef") != hash.npos)
      throw verifier::Malformed{"hash"};
    verifier::require(hash == verifier::sha256(elements_), "another elements file");
    const std::string basis = word_of("basis"), numbers = word_of("numbers");
    const verifier::Elements elements(elements_, basis, numbers);
    verifier::Tokens count(next());
    if (!count.accept("count")) throw verifier::Malformed{"expected count"};
    const mpz_class announced = count.integer();
    count.expect_end();
    verifier::require(announced == elements.count(), "count");
    for (std::size_t i = 0; i < elements.count(); ++i) {
      verifier::Tokens line(next());
      if (line.integer() != i + 1) throw verifier::Malformed{"position"};
      result.claims.push_back(verifier::check_element(elements.element(i), line));
      line.expect_end();
    }
    verifier::Tokens line(next());
    if (!line.accept("mesh")) throw verifier::Malformed{"expected mesh"};
    result.mesh = verifier::check_mesh(elements, result.claims, line, [this] {
      if (current_ == "end") throw verifier::Malformed{"the certificate ends too early"};
      return next();
    });
    if (current_ != "end" && next() != "end") throw verifier::Malformed{"expected end"};
    if (!rest_.empty()) throw verifier::Malformed{"text after end"};
  }

  const std::string& elements_;
  std::string_view rest_, current_;
  std::size_t line_ = 0;
};

inline Judgement judge(const std::string& elements, std::string_view certificate) {
  return Judge(elements, certificate)();
}

}  // namespace bezcert::test
