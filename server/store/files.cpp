#include "server/store/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace race::server {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 16U;

/// As errno says.
tl::unexpected<Error> cannot_read() {
  return unexpected(ErrorCode::io, std::string("cannot be read: ") + std::strerror(errno));
}

/// As errno says.
tl::unexpected<Error> cannot_write(const std::string& path) {
  return unexpected(ErrorCode::io, std::string("cannot be written: ") + std::strerror(errno), path);
}

bool write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file, text.data(), text.size());
    if (written < 0 && errno != EINTR) return false;
    if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace

Expected<std::string> read_open_file(int descriptor, std::size_t most) {
  std::string text;
  while (true) {
    const std::size_t size = text.size();
    text.resize(size + kBlock);
    const ssize_t got = ::read(descriptor, text.data() + size, kBlock);
    if (got < 0 && errno != EINTR) return cannot_read();
    text.resize(size + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    if (got == 0) return text;
    if (text.size() > most) return unexpected(ErrorCode::too_large, "has more than " + std::to_string(most) + " bytes");
  }
}

// Opening a pipe for reading does not wait for who writes it.
Expected<std::string> read_file(const std::string& path, std::size_t most) {
  const int opened = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  struct stat found = {};
  Expected<std::string> text = cannot_read();
  if (opened >= 0) {
    if (::fstat(opened, &found) == 0 && !S_ISREG(found.st_mode))
      text = unexpected(ErrorCode::io, "is no file");
    else
      text = read_open_file(opened, most);
    ::close(opened);
  }
  if (!text) text.error().path = path;
  return text;
}

Expected<bool> file_exists(const std::string& path) {
  std::error_code unknown;
  const auto kind = std::filesystem::status(path, unknown).type();
  if (kind == std::filesystem::file_type::not_found) return false;
  if (kind == std::filesystem::file_type::regular) return true;
  return unexpected(ErrorCode::io, unknown ? "cannot be read: " + unknown.message() : "is no file", path);
}

Expected<void> replace_file(const std::string& path, std::string_view text) {
  std::error_code unknown;
  const std::string target = std::filesystem::canonical(path, unknown);
  struct stat old = {};
  if (unknown || ::stat(target.c_str(), &old) != 0 || !S_ISREG(old.st_mode))
    return unexpected(ErrorCode::io, "is no file", path);
  return write_file(target, text, old.st_mode & 07777U);
}

Expected<void> write_file(const std::string& path, std::string_view text, unsigned permissions) {
  std::string beside = path + ".XXXXXX";  // mkstemp puts other letters in place of these
  const int file = ::mkstemp(beside.data());
  if (file < 0) return cannot_write(path);
  const bool written = write_all(file, text) && ::fchmod(file, permissions) == 0 && ::fsync(file) == 0;
  const int error = errno;
  const bool closed = ::close(file) == 0;
  if (written && closed && ::rename(beside.c_str(), path.c_str()) == 0) return {};
  if (!written) errno = error;
  const auto failure = cannot_write(path);
  ::unlink(beside.c_str());
  return failure;
}

}  // namespace race::server
