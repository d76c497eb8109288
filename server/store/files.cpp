#include "server/store/files.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace race::server {
namespace {

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

Expected<std::string> read_file(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.is_open() || stream.bad()) return unexpected(ErrorCode::io, "cannot be read", path);
  return text;
}

Expected<void> replace_file(const std::string& path, std::string_view text) {
  std::error_code unknown;
  const std::string target = std::filesystem::canonical(path, unknown);
  struct stat old = {};
  if (unknown || ::stat(target.c_str(), &old) != 0 || !S_ISREG(old.st_mode))
    return unexpected(ErrorCode::io, "is no file", path);
  std::string beside = target + ".XXXXXX";  // mkstemp puts other letters in place of these
  const int file = ::mkstemp(beside.data());
  if (file < 0) return cannot_write(path);
  const bool written = write_all(file, text) && ::fchmod(file, old.st_mode & 07777U) == 0 && ::fsync(file) == 0;
  const int error = errno;
  const bool closed = ::close(file) == 0;
  if (written && closed && ::rename(beside.c_str(), target.c_str()) == 0) return {};
  if (!written) errno = error;
  const auto failure = cannot_write(path);
  ::unlink(beside.c_str());
  return failure;
}

}  // namespace race::server
