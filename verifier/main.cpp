// verifier ELEMENTS CERTIFICATE: holds every line of the certificate against its rule; exit code 0 if all
// hold.
#include "mesh_rules.hpp"
#include "sha256.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace verifier {
namespace {

constexpr std::size_t most_characters = std::size_t{1} << 26;    // of a line
constexpr std::size_t most_number_bytes = std::size_t{1} << 25;  // 2^28 bits
constexpr std::ptrdiff_t most_bytes = std::ptrdiff_t{1} << 31;   // of all numbers together

/// Where the certificate is read.
struct Place {
  std::string file;
  std::size_t line = 0, element = 0;
} place;

[[noreturn]] void leave(int code, std::string text) {
  for (char& c : text) c = c < ' ' || c > '~' ? '?' : c;  // it may quote a file: one line, no escapes
  std::cout << (code == 1 ? "rejected: " : "malformed: ") << text << std::endl;
  std::_Exit(code);
}
[[noreturn]] void leave_here(int code, const std::string& why) {
  const std::string element = place.element ? "element " + std::to_string(place.element) + ": " : "";
  leave(code, place.file + ':' + std::to_string(place.line) + ": " + element + why);
}

// Memory of GMP, counted. GMP cannot give up, so this leaves the program.
std::ptrdiff_t bytes_in_use = 0;
void count_bytes(std::size_t old_size, std::size_t new_size) {
  bytes_in_use += static_cast<std::ptrdiff_t>(new_size) - static_cast<std::ptrdiff_t>(old_size);
  if (new_size > most_number_bytes) leave_here(2, "limit: a number of more than 2^28 bits");
  if (bytes_in_use > most_bytes) leave_here(2, "limit: numbers of more than 2 GiB");
}
void* checked(void* memory) { return memory ? memory : (leave_here(2, "limit: no memory"), nullptr); }
void* allocate(std::size_t size) { return count_bytes(0, size), checked(std::malloc(size)); }
void* reallocate(void* memory, std::size_t old_size, std::size_t new_size) {
  return count_bytes(old_size, new_size), checked(std::realloc(memory, new_size));
}
void release(void* memory, std::size_t size) { count_bytes(size, 0), std::free(memory); }

/// An error of usage.
struct Usage {
  std::string why;
};

std::string read_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string bytes;
  std::error_code error;
  if (const auto size = std::filesystem::file_size(path, error); !error) bytes.reserve(size);
  std::array<char, 65536> buffer;
  while (in.read(buffer.data(), buffer.size()), in.gcount() > 0)
    bytes.append(buffer.data(), static_cast<std::size_t>(in.gcount()));
  if (!in.is_open() || in.bad()) throw Usage{"cannot read " + path};
  return bytes;
}

/// The lines of the certificate, one at a time.
class Certificate {
 public:
  explicit Certificate(const std::string& path) : in_(path, std::ios::binary) {
    if (!in_ || in_.peek() == EOF) throw Usage{"cannot read " + path + ", or it is empty"};
    place.file = path;
  }
  /// Valid until the next call.
  std::string_view next() {
    begin_line();
    ++place.line;
    line_.clear();
    for (int c; (c = in_.rdbuf()->sbumpc()) != '\n'; line_ += static_cast<char>(c)) {
      if (c == EOF) throw Malformed{"the certificate ends too early"};
      if (line_.size() == most_characters) throw Malformed{"limit: line of more than 2^26 characters"};
    }
    return line_;
  }
  std::string_view current() const { return line_; }
  bool at_end() { return in_.rdbuf()->sgetc() == EOF; }

 private:
  std::ifstream in_;
  std::string line_;
};

/// The rest of the line "`key` WORD".
std::string header(Certificate& certificate, std::string_view key) {
  Tokens tokens(certificate.next());
  if (!tokens.accept(key)) throw Malformed{"expected " + std::string(key)};
  const std::string word(tokens.word());
  tokens.expect_end();
  return word;
}

std::string verify(const std::string& elements_path, const std::string& certificate_path) {
  Certificate certificate(certificate_path);
  std::string bytes = read_file(elements_path);
  if (header(certificate, "bezcert-certificate") != "1") throw Malformed{"version is not 1"};
  const std::string hash = header(certificate, "elements");
  if (hash.size() != 64 || hash.find_first_not_of("0123456789abcdef") != hash.npos)
    throw Malformed{"not a SHA-256 in lower-case hex"};
  require(hash == sha256(bytes), "it is about another elements file: SHA-256 differs");
  const std::string basis = header(certificate, "basis"), numbers = header(certificate, "numbers");
  const Elements elements(std::move(bytes), basis, numbers);
  const std::string announced = header(certificate, "count");
  require(Tokens(announced).integer() == elements.count(),
          "the elements file has another number of elements");

  std::vector<Claim> claims;
  std::array<std::size_t, 8> tally{};
  while (claims.size() < elements.count()) {
    Tokens line(certificate.next());
    place.element = claims.size() + 1;
    if (line.integer() != place.element) throw Malformed{"not the position that follows"};
    claims.push_back(check_element(elements.element(claims.size()), line));
    line.expect_end();
    ++tally[static_cast<std::size_t>(claims.back())];
  }
  place.element = 0;
  Tokens line(certificate.next());
  if (!line.accept("mesh")) throw Malformed{"expected mesh"};
  const std::string mesh = check_mesh(elements, claims, line, [&] {
    if (certificate.current() == "end") throw Malformed{"the certificate ends too early"};
    return certificate.next();
  });
  if (certificate.current() != "end" && certificate.next() != "end") throw Malformed{"expected end"};
  if (!certificate.at_end()) throw Malformed{"text after end"};

  std::string answer = "accepted: " + elements_path;
  if (basis == "mixed")
    answer += ", exact";
  else
    answer += (basis == "lagrange" ? " as lagrange nodes, " : " as bernstein control points, ") + numbers;
  answer += ": " + std::to_string(claims.size()) + " elements:";
  const char* names[] = {"injective", "regular",  "overlapping", "degenerate",
                         "folded",    "reversed", "invalid",     "undecided"};
  for (std::size_t c = 0; c < tally.size(); ++c)
    if (tally[c]) answer += ' ' + std::to_string(tally[c]) + ' ' + names[c] + ',';
  answer.back() = ';';
  return answer + " mesh: " + mesh;
}

}  // namespace
}  // namespace verifier

int main(int count, char** arguments) {
  using namespace verifier;
  const char usage[] =
      "usage: verifier ELEMENTS CERTIFICATE\n"
      "Checks what certify check --certificate wrote about an elements file (.msh, .bez.json).\n"
      "Exit code: 0 accepted, 1 rejected, 2 malformed, beyond the limits, or not to be read.\n";
  mp_set_memory_functions(allocate, reallocate, release);
  try {
    if (count == 2 && std::string_view(arguments[1]) == "--help") return std::cout << usage, 0;
    if (count != 3) throw Usage{"expected two files, see --help"};
    std::cout << verify(arguments[1], arguments[2]) << std::endl;
    return std::cout ? 0 : 2;
  } catch (const Usage& error) {
    std::cerr << "verifier: " << error.why << std::endl;
    return 2;
  } catch (const MalformedElements& error) {
    leave(2, arguments[1] + (':' + error.why));
  } catch (const Malformed& error) {
    leave_here(2, error.why);
  } catch (const Rejected& error) {
    leave_here(1, error.why);
  } catch (const std::exception& error) {
    leave_here(2, std::string("limit: ") + error.what());
  }
}
