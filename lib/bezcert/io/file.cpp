#include "bezcert/io/file.hpp"

#include "bezcert/io/input_error.hpp"

#include <fcntl.h>
#include <openssl/evp.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace bezcert {
namespace {

struct Descriptor {
  int number;

  explicit Descriptor(int opened) : number(opened) {}
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
};

}  // namespace

std::string read_file(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (error || !std::filesystem::exists(status)) throw InputError(path, 0, "no such file");
  if (std::filesystem::is_directory(status)) throw InputError(path, 0, "is a folder, expected a mesh file");
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.number < 0) throw InputError(path, 0, std::string("cannot be read: ") + std::strerror(errno));
  // Into place, by what the file is said to be long; a pipe or a file that grows is read to its end.
  const auto size = std::filesystem::file_size(path, error);
  std::string bytes(error ? 0 : size + 1, '\0');
  std::size_t filled = 0;
  for (;;) {
    if (filled == bytes.size()) bytes.resize(2 * bytes.size() + (1 << 16));
    const ssize_t count = ::read(file.number, bytes.data() + filled, bytes.size() - filled);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw InputError(path, 0, "cannot be read to its end");
    if (count == 0) break;
    filled += static_cast<std::size_t>(count);
  }
  bytes.resize(filled);
  return bytes;
}

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1) {
    throw std::runtime_error("sha256: the digest failed");
  }
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (unsigned int i = 0; i < length; ++i) {
    text += digits[digest[i] >> 4];
    text += digits[digest[i] & 15];
  }
  return text;
}

void write_file(const std::string& path, const std::function<void(std::ostream&)>& write) {
  namespace fs = std::filesystem;
  std::error_code error;
  // A link stands for what it points at; only regular files are replaced, a pipe or device is written to.
  const fs::path target = fs::exists(path, error) ? fs::canonical(path, error) : fs::path(path);
  if (error) throw InputError(path, 0, "cannot be written: " + error.message());
  const fs::file_status status = fs::status(target, error);
  error.clear();  // a target that does not exist is no error
  const bool replaces = fs::is_regular_file(status);
  if (fs::exists(status) && !replaces) {
    if (fs::is_directory(status)) throw InputError(path, 0, "cannot be written: is a folder");
    std::ofstream stream(target, std::ios::binary);
    if (!stream) throw InputError(path, 0, std::string("cannot be written: ") + std::strerror(errno));
    write(stream);
    stream.close();
    if (!stream) throw InputError(path, 0, "cannot be written to its end");
    return;
  }
  // Beside the target, named after it, and no longer than a name may be.
  const fs::path temporary = target.parent_path() / (target.filename().string().substr(0, 200) + ".tmp" +
                                                     std::to_string(::getpid()));
  std::ofstream stream(temporary, std::ios::binary | std::ios::trunc);
  if (!stream) throw InputError(path, 0, std::string("cannot be written: ") + std::strerror(errno));
  try {
    write(stream);
    stream.close();
    if (!stream) throw InputError(path, 0, "cannot be written: the disk may be full");
    if (replaces) fs::permissions(temporary, status.permissions(), error);
    if (!error) fs::rename(temporary, target, error);
    if (error) throw InputError(path, 0, "cannot be written: " + error.message());
  } catch (...) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw;
  }
}

}  // namespace bezcert
