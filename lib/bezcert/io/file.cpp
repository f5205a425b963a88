#include "bezcert/io/file.hpp"

#include "bezcert/io/input_error.hpp"

#include <fcntl.h>
#include <nettle/sha2.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <locale>

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

int open_to_read(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (error || !std::filesystem::exists(status)) throw InputError(path, 0, "no such file");
  if (std::filesystem::is_directory(status)) throw InputError(path, 0, "is a folder, expected a mesh file");
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw InputError(path, 0, std::string("cannot be read: ") + std::strerror(errno));
  return descriptor;
}

// Into place, by what the file is said to be long; a pipe or a file that grows is read to its end.
std::string read_all(int descriptor, const std::string& path) {
  struct stat status {};
  const bool known = ::fstat(descriptor, &status) == 0 && status.st_size > 0;
  std::string bytes(known ? static_cast<std::size_t>(status.st_size) + 1 : 0, '\0');
  std::size_t filled = 0;
  for (;;) {
    if (filled == bytes.size()) bytes.resize(2 * bytes.size() + (1 << 16));
    const ssize_t count = ::read(descriptor, bytes.data() + filled, bytes.size() - filled);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw InputError(path, 0, "cannot be read to its end");
    if (count == 0) break;
    filled += static_cast<std::size_t>(count);
  }
  bytes.resize(filled);
  return bytes;
}

// What changes when the file does: size, and time of the last writing.
std::array<long, 3> state_of(int descriptor) {
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) return {};
  return {static_cast<long>(status.st_size), status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
}

}  // namespace

std::string read_file(const std::string& path) {
  const Descriptor file(open_to_read(path));
  return read_all(file.number, path);
}

FileBytes::FileBytes(const std::string& path) : path_(path), descriptor_(open_to_read(path)) {
  state_ = state_of(descriptor_);
  struct stat status {};
  const bool regular = ::fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode) && status.st_size > 0;
  const auto size = static_cast<std::size_t>(status.st_size);
  void* const place =
      regular ? ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_POPULATE, descriptor_, 0) : MAP_FAILED;
  if (place != MAP_FAILED) {
    is_mapped_ = true;
    bytes_ = {static_cast<const char*>(place), size};
    return;
  }
  try {
    read_ = read_all(descriptor_, path_);
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
  bytes_ = read_;
}

FileBytes::~FileBytes() {
  if (is_mapped_) ::munmap(const_cast<char*>(bytes_.data()), bytes_.size());
  ::close(descriptor_);
}

void FileBytes::check_unchanged() const {
  if (is_mapped_ && state_of(descriptor_) != state_) {
    throw InputError(path_, 0, "was written to while it was read: expected a file that stays as it is");
  }
}

std::string sha256(std::string_view bytes) {
  sha256_ctx state;
  sha256_init(&state);
  sha256_update(&state, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
  sha256_digest(&state, digest.size(), digest.data());
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : digest) {
    text += digits[byte >> 4];
    text += digits[byte & 15];
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
    stream.imbue(std::locale::classic());
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
  stream.imbue(std::locale::classic());
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
