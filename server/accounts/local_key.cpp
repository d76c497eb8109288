#include "server/accounts/local_key.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "server/accounts/secret.h"
#include "server/store/files.h"

namespace race::server {
namespace {

constexpr std::size_t kMostBytes = 1000;
constexpr std::string_view kSpace = " \t\r\n";

tl::unexpected<Error> of_system(const std::string& path) {
  return unexpected(ErrorCode::io, std::strerror(errno), path);
}

// A file that is there already stays.
Expected<void> make_token_file(const std::string& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, S_IRUSR | S_IWUSR);
  if (file < 0 && errno == EEXIST) return {};
  if (file < 0) return of_system(path);
  const std::string text = make_secret(kTokenPrefix) + '\n';
  const bool written = ::write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  const auto result = written ? Expected<void>() : of_system(path);
  ::close(file);
  if (!written) ::unlink(path.c_str());
  return result;
}

std::string trimmed(const std::string& text) {
  const std::size_t from = text.find_first_not_of(kSpace);
  if (from == std::string::npos) return "";
  return text.substr(from, text.find_last_not_of(kSpace) + 1 - from);
}

}  // namespace

Expected<std::string> read_private_file(const std::string& path) {
  struct stat known {};
  if (::stat(path.c_str(), &known) != 0) return of_system(path);
  if ((known.st_mode & (S_IRWXG | S_IRWXO)) != 0)
    return unexpected(ErrorCode::not_accepted, "others may use this file: it needs the permissions 0600", path);
  return read_file(path, kMostBytes);
}

Expected<std::string> read_token_file(const std::string& path) {
  ASSIGN_OR_RETURN(const std::string text, read_private_file(path));
  std::string secret = trimmed(text);
  if (!secret.starts_with(kTokenPrefix)) return unexpected(ErrorCode::not_accepted, "this file holds no token", path);
  return secret;
}

Expected<LocalKey> LocalKey::open(const std::string& path, std::vector<std::string> groups) {
  if (auto made = make_token_file(path); !made) return tl::unexpected(std::move(made).error());
  ASSIGN_OR_RETURN(const std::string secret, read_token_file(path));
  return LocalKey(digest_of_secret(secret), std::move(groups));
}

bool LocalKey::is(std::string_view secret) const { return digest_of_secret(secret) == digest_; }

Identity LocalKey::identity() const { return {"", Role::process, groups_, digest_, ""}; }

}  // namespace race::server
