// verifier ELEMENTS CERTIFICATE: holds every line of the certificate against its rule; exit code 0 if all
// hold.
#include "rules.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>

namespace verifier {
namespace {

constexpr std::size_t most_characters = std::size_t{1} << 26;    // of a line
constexpr std::size_t most_number_bytes = std::size_t{1} << 25;  // 2^28 bits
constexpr std::size_t least_number_bytes = 24;                   // there is room for so many at least
constexpr std::size_t most_bytes = std::size_t{1} << 31;         // of all numbers together

/// The certificate, line by line.
struct Certificate {
  std::string path;
  std::ifstream in{};
  std::string line{};
  std::size_t number = 0;  ///< of the line

  std::string_view next() {
    begin_line();
    ++number;
    line.clear();
    for (int c; (c = in.rdbuf()->sbumpc()) != '\n'; line += static_cast<char>(c)) {
      if (c == EOF) throw Malformed{"the certificate ends too early, or cannot be read"};
      if (line.size() == most_characters) throw Malformed{"limit: line of more than 2^26 characters"};
    }
    return line;
  }
  /// The rest of the line "`key` WORD".
  std::string header(std::string_view key) {
    Tokens tokens(next());
    if (!tokens.accept(key)) throw Malformed{"expected " + std::string(key)};
    const std::string word(tokens.word());
    tokens.expect_end();
    return word;
  }
} certificate;

[[noreturn]] void leave(int code, const std::string& why) {
  std::string text = certificate.path + ':' + std::to_string(certificate.number) + ": " + why;
  for (char& c : text) c = c < ' ' || c > '~' ? '?' : c;  // it may quote a file: one line, no escapes
  std::cout << (code == 1 ? "rejected: " : "malformed: ") << text << std::endl;
  std::_Exit(code);
}

// Memory of GMP, counted. GMP cannot give up, so this leaves the program. Small blocks are kept for the next
// number.
std::size_t bytes_in_use = 0;
auto& spare = *new std::vector<void*>;  // never destroyed
void* reallocate(void* memory, std::size_t old_size, std::size_t new_size) {
  bytes_in_use += new_size - old_size;
  if (new_size > most_number_bytes) leave(2, "limit: a number of more than 2^28 bits");
  if (bytes_in_use > most_bytes) leave(2, "limit: numbers of more than 2 GiB");
  if (memory != nullptr && std::max(old_size, new_size) <= least_number_bytes) return memory;
  memory = std::realloc(memory, std::max(new_size, least_number_bytes));
  if (memory == nullptr) leave(2, "limit: no memory");
  return memory;
}
void* allocate(std::size_t size) {
  void* block = nullptr;
  if (size <= least_number_bytes && !spare.empty()) block = spare.back(), spare.pop_back();
  return reallocate(block, 0, size);
}
void release(void* memory, std::size_t size) {
  bytes_in_use -= size;
  size <= least_number_bytes ? spare.push_back(memory) : std::free(memory);
}

std::string read_file(const std::string& path) {
  std::string bytes(std::filesystem::file_size(path), '\0');
  std::ifstream in(path, std::ios::binary);
  if (!in.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
    throw Malformed{"cannot read " + path};
  return bytes;
}

/// What is accepted, in words.
std::string verify(const std::string& elements_path) {
  std::string bytes = read_file(elements_path);
  if (certificate.header("bezcert-certificate") != "1") throw Malformed{"version is not 1"};
  const std::string hash = certificate.header("elements");
  if (hash.size() != 64 || hash.find_first_not_of("0123456789abcdef") != hash.npos)
    throw Malformed{"not a SHA-256 in lower-case hex"};
  require(hash == sha256(bytes), "it is about another elements file: SHA-256 differs");
  const std::string basis = certificate.header("basis"), numbers = certificate.header("numbers");
  const Elements elements(std::move(bytes), basis, numbers);
  const std::string count = certificate.header("count");
  require(Tokens(count).integer() == elements.count(), "the elements file has another number of elements");

  std::vector<Claim> claims;
  std::map<std::string, std::size_t> tally;
  while (claims.size() < elements.count()) {
    Tokens line(certificate.next());
    if (line.integer() != claims.size() + 1) throw Malformed{"not the position that follows"};
    ++tally[std::string(Tokens(line).word())];
    claims.push_back(check_element(elements.element(claims.size()), line));
    line.expect_end();
  }
  Tokens line(certificate.next());
  if (!line.accept("mesh")) throw Malformed{"expected mesh"};
  const std::string mesh = check_mesh(elements, claims, line, [] {
    if (certificate.line == "end") throw Malformed{"the certificate ends too early"};
    return certificate.next();
  });
  if (certificate.line != "end" && certificate.next() != "end") throw Malformed{"expected end"};
  if (certificate.in.peek() != EOF) throw Malformed{"text after end"};

  const std::string kind = basis == "lagrange" ? " as lagrange nodes, " : " as bernstein control points, ";
  std::string answer = "accepted: " + elements_path + (basis == "mixed" ? ", exact" : kind + numbers) + ": " +
                       std::to_string(claims.size()) + " elements:";
  for (const auto& [claim, times] : tally) answer += ' ' + std::to_string(times) + ' ' + claim + ',';
  answer.back() = ';';
  return answer + " mesh: " + mesh;
}

}  // namespace
}  // namespace verifier

int main(int count, char** arguments) {
  using namespace verifier;
  if (count != 3) {
    std::cerr << "usage: verifier ELEMENTS CERTIFICATE\n"
                 "Checks what certify check --certificate wrote about an elements file (.msh, .bez.json).\n"
                 "Exit code: 0 accepted, 1 rejected, 2 malformed, beyond the limits, or not to be read.\n";
    return 2;
  }
  mp_set_memory_functions(allocate, reallocate, release);
  try {
    certificate.path = arguments[2];
    certificate.in.open(certificate.path, std::ios::binary);
    std::cout << verify(arguments[1]) << std::endl;
    return std::cout ? 0 : 2;
  } catch (const Malformed& error) {
    leave(2, error.why);
  } catch (const Rejected& error) {
    leave(1, error.why);
  } catch (const std::exception& error) {
    leave(2, error.what());
  }
}
