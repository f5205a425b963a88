// The mutants of a certificate: every token in turn replaced by wrong ones. oracle/mutants.py makes the same
// ones, in the same order.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

namespace bezcert::test {

struct Mutation {
  std::string kind, token;  ///< the new token; empty: dropped
};

inline std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

inline const std::vector<std::vector<std::string>>& word_classes() {
  static const std::vector<std::vector<std::string>> classes = [] {
    std::vector<std::vector<std::string>> result;
    for (const char* line : {"injective regular overlapping degenerate folded reversed invalid undecided",
                             "coefficients tree factors columns hull", "midpoint hull orientation boundary",
                             "none + -", "m h s j a b r", "open root slab", "at root cross",
                             "undecided embedding refuted", "element cover touch pinch gap", "glue pair end",
                             "u v", "lagrange bernstein mixed", "binary64 decimal"}) {
      result.push_back(split(line, ' '));
    }
    return result;
  }();
  return classes;
}

inline std::vector<Mutation> mutations_of(const std::string& token, const std::string& before) {
  if (before == "elements") {
    const std::string digits = "0123456789abcdef";
    return {{"hash", digits[(digits.find(token[0]) + 1) % 16] + token.substr(1)}};
  }
  std::vector<Mutation> result;
  const auto among = [&](const char* set) { return token.find_first_not_of(set) == token.npos; };
  if (before == "tree") {
    for (std::size_t i = 0; i < std::min<std::size_t>(token.size(), 48); ++i) {
      std::string flipped = token;
      flipped[i] = token[i] == '0' ? '1' : '0';
      result.push_back({"bits", flipped});
    }
    for (const std::string& other : {token + '0', token + '1', token.substr(0, token.size() - 1)})
      result.push_back({"bits", other});
  } else if (among("-0123456789/,;.") && token.find_first_of("0123456789") != token.npos) {
    const auto digit = [&](std::size_t i) { return i < token.size() && token[i] >= '0' && token[i] <= '9'; };
    for (std::size_t begin = 0; begin < token.size();) {
      std::size_t end = begin + (token[begin] == '-' && digit(begin + 1));
      if (!digit(end)) {
        ++begin;
        continue;
      }
      while (digit(end)) ++end;
      const std::string text = token.substr(begin, end - begin);
      const mpz_class value(text);
      std::string last = text;
      last.back() = static_cast<char>('0' + (last.back() - '0' + 3) % 10);
      const mpz_class more = value + 1, negated = value == 0 ? mpz_class(-1) : mpz_class(-value);
      for (const std::string& other : {more.get_str(), negated.get_str(), last})
        result.push_back({"number", token.substr(0, begin) + other + token.substr(end)});
      begin = end;
    }
  } else {
    std::vector<std::string> others;
    for (const auto& words : word_classes()) {
      if (std::find(words.begin(), words.end(), token) == words.end()) continue;
      for (const std::string& word : words)
        if (word != token && std::find(others.begin(), others.end(), word) == others.end())
          others.push_back(word);
    }
    for (const std::string& word : others) result.push_back({"word", word});
  }
  result.push_back({"token", ""});
  result.push_back({"token", token + ' ' + token});
  return result;
}

/// Calls use(kind, line, token, replacement, certificate) for every mutant; lines and tokens are counted
/// from 1.
inline void for_each_mutant(
    const std::string& certificate,
    const std::function<void(const Mutation&, std::size_t, std::size_t, const std::string&)>& use) {
  std::vector<std::string> lines = split(certificate, '\n');
  lines.pop_back();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::vector<std::string> tokens = split(lines[i], ' ');
    for (std::size_t k = 0; k < tokens.size(); ++k) {
      for (const Mutation& mutation : mutations_of(tokens[k], k > 0 ? tokens[k - 1] : "")) {
        std::string line;
        for (std::size_t l = 0; l < tokens.size(); ++l) {
          const std::string& token = l == k ? mutation.token : tokens[l];
          if (!token.empty()) line += (line.empty() ? "" : " ") + token;
        }
        std::string mutant;
        for (std::size_t l = 0; l < lines.size(); ++l) mutant += (l == i ? line : lines[l]) + '\n';
        use(mutation, i + 1, k + 1, mutant);
      }
    }
  }
}

}  // namespace bezcert::test
