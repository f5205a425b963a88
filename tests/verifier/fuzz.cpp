// Fuzzes the verifier (its sources compiled into this program with -fsanitize=address,undefined): pairs of an
// elements file and a certificate, made from the examples by seeded changes. Nothing may crash or take long,
// and no element that an example proves not to be injective may be accepted as injective.
//
//   fuzz FOLDER [--runs N] [--seconds S] [--seed X]      tests/verifier, what to run
//   fuzz --input FILE                                    one saved input again
//
// Inputs run in children, some hundreds each: a limit of GMP's memory leaves by exit, a crash by a signal.
#include "checking.hpp"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <sstream>

namespace {

using bezcert::test::Judgement;
using verifier::Claim;

const std::string separator = "\n=====\n";
constexpr unsigned most_seconds = 30;                     // of one input
constexpr std::ptrdiff_t most_bytes = 512 * 1024 * 1024;  // of GMP
constexpr int exit_limit = 77, exit_false = 78;
constexpr std::size_t batch = 400;

std::string read(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// GMP's memory, as main.cpp counts it: it cannot give up, so this leaves the child.
std::ptrdiff_t bytes_in_use = 0;
void count_bytes(std::size_t more) {
  bytes_in_use += static_cast<std::ptrdiff_t>(more);
  if (bytes_in_use > most_bytes) ::_exit(exit_limit);
}
void* allocate(std::size_t size) { return count_bytes(size), std::malloc(size); }
void* reallocate(void* memory, std::size_t old_size, std::size_t size) {
  return count_bytes(size - old_size), std::realloc(memory, size);
}
void release(void* memory, std::size_t size) { count_bytes(std::size_t{0} - size), std::free(memory); }

struct Input {
  std::string elements, certificate;
  std::vector<bool> may_be_injective;  // by element; empty: not known
};

/// What is run on every input, as LLVMFuzzerTestOneInput is: 0, or the exit code of a false acceptance.
int test_one_input(const Input& input, std::size_t (&codes)[3]) {
  const Judgement judgement = bezcert::test::judge(input.elements, input.certificate);
  ++codes[judgement.code];
  if (judgement.code == 0 && judgement.claims.size() == input.may_be_injective.size())
    for (std::size_t i = 0; i < judgement.claims.size(); ++i)
      if (!input.may_be_injective[i] && judgement.claims[i] == Claim::injective) return exit_false;
  return 0;
}

struct Pair {
  std::string name, elements, certificate;
  std::vector<bool> may_be_injective;
};

std::vector<Pair> pairs_of(const std::string& folder) {
  std::vector<Pair> pairs;
  std::ifstream table(folder + "/expected.tsv");
  for (std::string row; std::getline(table, row);) {
    std::istringstream words(row);
    std::string certificate, elements;
    int code = 0;
    if (row.starts_with('#') || !(words >> certificate >> elements >> code)) continue;
    Pair pair{certificate, read(folder + "/elements/" + elements), read(folder + "/" + certificate), {}};
    if (code == 0)
      for (const Claim claim : bezcert::test::judge(pair.elements, pair.certificate).claims)
        pair.may_be_injective.push_back(claim == Claim::injective || claim == Claim::regular ||
                                        claim == Claim::undecided);
    pairs.push_back(pair);
  }
  // A certificate that is rejected may be of an element that another one proves not to be injective.
  for (Pair& pair : pairs)
    for (const Pair& other : pairs)
      if (other.elements == pair.elements && !other.may_be_injective.empty() &&
          other.certificate.find("basis bernstein") == pair.certificate.find("basis bernstein") &&
          other.certificate.find("numbers decimal") == pair.certificate.find("numbers decimal")) {
        if (pair.may_be_injective.empty()) pair.may_be_injective = other.may_be_injective;
        for (std::size_t i = 0; i < pair.may_be_injective.size(); ++i)
          pair.may_be_injective[i] = pair.may_be_injective[i] && other.may_be_injective[i];
      }
  return pairs;
}

class Mutator {
 public:
  Mutator(const std::vector<Pair>& pairs, std::uint64_t seed) : pairs_(pairs), seed_(seed) {}

  Input input(std::size_t index) {
    engine_.seed(seed_ * 1'000'003 + index);
    const Pair* chosen = &pairs_[below(pairs_.size())];
    for (int i = 0; i < 3 && chosen->name.starts_with("malformed"); ++i)
      chosen = &pairs_[below(pairs_.size())];
    const Pair& pair = *chosen;
    Input input{pair.elements, pair.certificate, pair.may_be_injective};
    // The basis and the numbers say what the element is: changed, nothing is known of it.
    const std::size_t header = pair.certificate.find("basis"), count = pair.certificate.find("count");
    const std::string reading =
        pair.certificate.substr(std::min(header, pair.certificate.size()), count - header);
    if (below(10) < 2) {
      change(input.elements);
      input.may_be_injective.clear();
    }
    for (std::size_t changes = below(2) == 0 ? 1 : 1 + below(4); changes > 0; --changes)
      change(input.certificate);
    if (below(10) < 9) fix_hash(input);
    if (input.certificate.find(reading) == std::string::npos) input.may_be_injective.clear();
    return input;
  }

 private:
  std::size_t below(std::size_t n) { return n == 0 ? 0 : engine_() % n; }

  static std::vector<std::pair<std::size_t, std::size_t>> tokens_of(const std::string& text) {
    std::vector<std::pair<std::size_t, std::size_t>> tokens;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
      if (end > at) tokens.emplace_back(at, end - at);
      at = end + 1;
    }
    return tokens;
  }

  void change(std::string& text) {
    static const std::vector<std::string> extreme = {"0",
                                                     "1",
                                                     "-1",
                                                     "2",
                                                     "1/2",
                                                     "-1/2",
                                                     "3/2",
                                                     "4294967296",
                                                     "-9223372036854775808",
                                                     "18446744073709551616",
                                                     "1/18446744073709551616",
                                                     std::string(400, '9'),
                                                     "-" + std::string(5000, '7'),
                                                     "1/1" + std::string(900, '0'),
                                                     "1e5000",
                                                     "1e-5000",
                                                     "0,1",
                                                     "0,0,1",
                                                     "-2,0,1",
                                                     "0;1",
                                                     "1;1",
                                                     "0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1",
                                                     "100",
                                                     "11000",
                                                     "1110000",
                                                     "1.0",
                                                     "2.2",
                                                     "9.9",
                                                     "4096",
                                                     "-",
                                                     "open",
                                                     "root",
                                                     "slab",
                                                     "at",
                                                     "cross",
                                                     "r",
                                                     "h",
                                                     "a",
                                                     "injective",
                                                     "regular",
                                                     "coefficients",
                                                     "factors",
                                                     "columns",
                                                     "hull",
                                                     "boundary",
                                                     "embedding",
                                                     "refuted",
                                                     "touch",
                                                     "gap",
                                                     "pinch",
                                                     "cover",
                                                     "midpoint",
                                                     "pair"};
    const auto tokens = tokens_of(text);
    const auto replace = [&](const std::string& with) {
      if (tokens.empty()) return;
      const auto [at, size] = tokens[below(tokens.size())];
      text.replace(at, size, with);
    };
    switch (below(16)) {
      case 0:
        if (!text.empty()) text[below(text.size())] = static_cast<char>(below(256));
        break;
      case 1:
        if (!text.empty()) text[below(text.size())] ^= static_cast<char>(1 << below(8));
        break;
      case 2: text.resize(below(text.size() + 1)); break;
      case 3: text.insert(below(text.size() + 1), extreme[below(extreme.size())]); break;
      case 4: {  // a piece of another certificate
        const std::string& other = pairs_[below(pairs_.size())].certificate;
        const std::size_t at = below(other.size());
        text.insert(below(text.size() + 1), other.substr(at, below(80)));
        break;
      }
      case 5: {  // two tokens exchanged
        if (tokens.empty()) break;
        auto first = tokens[below(tokens.size())], second = tokens[below(tokens.size())];
        if (first.first >= second.first) break;
        const std::string a = text.substr(first.first, first.second),
                          b = text.substr(second.first, second.second);
        text.replace(second.first, second.second, a);
        text.replace(first.first, first.second, b);
        break;
      }
      case 6: {  // a token of another certificate
        const std::string& other = pairs_[below(pairs_.size())].certificate;
        const auto others = tokens_of(other);
        if (!others.empty()) {
          const auto [at, size] = others[below(others.size())];
          replace(other.substr(at, size));
        }
        break;
      }
      case 7: {  // a line of another certificate
        const std::string& other = pairs_[below(pairs_.size())].certificate;
        const std::size_t at = other.find('\n', below(other.size() + 1)),
                          to = text.find('\n', below(text.size() + 1));
        if (at == other.npos || to == text.npos) break;
        text.insert(to, other.substr(at, other.find('\n', at + 1) - at));
        break;
      }
      case 8: {  // a line twice, or away
        const std::size_t at = text.find('\n', below(text.size() + 1));
        if (at == text.npos) break;
        const std::size_t end = std::min(text.find('\n', at + 1), text.size());
        if (below(2) == 0) {
          text.insert(at, text.substr(at, end - at));
        } else {
          text.erase(at, end - at);
        }
        break;
      }
      case 9:
      case 10: replace(extreme[below(extreme.size())]); break;
      default: {  // a digit, a sign or a bit
        const std::size_t at = text.find_first_of("0123456789", below(text.size() + 1));
        if (at == text.npos) break;
        if (below(4) == 0) {
          text.insert(at, 1, below(2) == 0 ? '-' : static_cast<char>('1' + below(9)));
        } else {
          text[at] = static_cast<char>('0' + below(text[at] < '2' && below(2) == 0 ? 2 : 10));
        }
      }
    }
  }

  static void fix_hash(Input& input) {
    const std::size_t at = input.certificate.find("elements ");
    if (at == std::string::npos) return;
    const std::size_t end = std::min(input.certificate.find('\n', at), input.certificate.size());
    input.certificate.replace(at, end - at, "elements " + verifier::sha256(input.elements));
  }

  const std::vector<Pair>& pairs_;
  std::uint64_t seed_;
  std::mt19937_64 engine_;
};

struct Shared {
  std::size_t next, codes[3], limits;
};

std::string outcome(int status) {
  if (WIFSIGNALED(status))
    return WTERMSIG(status) == SIGALRM ? "took more than " + std::to_string(most_seconds) + " s"
                                       : "signal " + std::to_string(WTERMSIG(status));
  return WEXITSTATUS(status) == exit_false ? "an element that is not injective was accepted as injective"
                                           : "exit code " + std::to_string(WEXITSTATUS(status));
}

int replay(const std::string& path) {
  const std::string bytes = read(path);
  const std::size_t at = bytes.find(separator);
  Input input{bytes.substr(0, at), at == bytes.npos ? "" : bytes.substr(at + separator.size()), {}};
  std::size_t codes[3] = {0, 0, 0};
  const int code = test_one_input(input, codes);
  std::cout << path << ": " << (codes[0] ? "accepted" : codes[1] ? "rejected" : "malformed") << std::endl;
  return code;
}

}  // namespace

int main(int count, char** arguments) {
  std::string folder, single;
  std::size_t runs = 30000, seconds = 20;
  std::uint64_t seed = 20261122;
  if (const char* text = std::getenv("BEZCERT_SEED")) seed = std::strtoull(text, nullptr, 10);
  for (int i = 1; i < count; ++i) {
    const std::string word = arguments[i];
    const auto number = [&] { return i + 1 < count ? std::strtoull(arguments[++i], nullptr, 10) : 0; };
    if (word == "--runs") {
      runs = number();
    } else if (word == "--seconds") {
      seconds = number();
    } else if (word == "--seed") {
      seed = number();
    } else if (word == "--input" && i + 1 < count) {
      single = arguments[++i];
    } else {
      folder = word;
    }
  }
  mp_set_memory_functions(allocate, reallocate, release);
  if (!single.empty()) return replay(single);
  std::size_t replayed = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder + "/findings")) {
    if (entry.path().extension() != ".input") continue;
    ++replayed;
    const pid_t child = ::fork();
    if (child == 0) {
      ::alarm(most_seconds);
      std::_Exit(replay(entry.path()));
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    if (status != 0 && !(WIFEXITED(status) && WEXITSTATUS(status) == exit_limit)) {
      std::cout << entry.path() << ": " << outcome(status) << std::endl;
      return 1;
    }
  }

  const std::vector<Pair> pairs = pairs_of(folder);
  Mutator mutator(pairs, seed);
  auto* shared = static_cast<Shared*>(
      ::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
  std::memset(shared, 0, sizeof(Shared));
  const auto start = std::chrono::steady_clock::now();
  const auto time_is_up = [&] {
    return std::chrono::steady_clock::now() - start > std::chrono::seconds(seconds);
  };
  std::size_t failures = 0;
  while (shared->next < runs && !time_is_up() && failures < 5) {
    const std::size_t end = std::min(runs, shared->next + batch);
    std::cout.flush();
    const pid_t child = ::fork();
    if (child < 0) return 3;
    if (child == 0) {
      for (; shared->next < end && !time_is_up(); ++shared->next) {
        const Input input = mutator.input(shared->next);
        ::alarm(most_seconds);
        const int code = test_one_input(input, shared->codes);
        ::alarm(0);
        if (code != 0) std::_Exit(code);
      }
      std::_Exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    if (status == 0) continue;
    const std::size_t index = shared->next++;
    if (WIFEXITED(status) && WEXITSTATUS(status) == exit_limit) {
      ++shared->limits;
      continue;
    }
    ++failures;
    const Input input = mutator.input(index);
    const std::string name = "fuzz-" + std::to_string(seed) + "-" + std::to_string(index) + ".input";
    std::ofstream(name, std::ios::binary) << input.elements << separator << input.certificate;
    std::cout << "seed " << seed << ", input " << index << ": " << outcome(status) << "; saved as "
              << std::filesystem::absolute(name).string() << ", to be moved to tests/verifier/findings/"
              << std::endl;
  }
  std::cout << "seed " << seed << ": " << shared->next << " inputs of " << pairs.size() << " pairs and "
            << replayed << " findings: " << shared->codes[0] << " accepted, " << shared->codes[1]
            << " rejected, " << shared->codes[2] << " malformed, " << shared->limits << " beyond the memory"
            << std::endl;
  const bool enough =
      shared->next >= 500 && shared->codes[0] > 0 && shared->codes[1] > 0 && shared->codes[2] > 0;
  if (!enough) std::cout << "too few inputs of a kind" << std::endl;
  return failures == 0 && enough ? 0 : 1;
}
