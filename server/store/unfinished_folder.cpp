#include "server/store/unfinished_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "server/store/durable_files.h"

namespace race::server {
namespace {

namespace fs = std::filesystem;

constexpr const char* kUnfinished = ".unfinished";

/// The folder, locked; negative: errno says why not, EWOULDBLOCK: a process holds it.
int lock_folder(const fs::path& path) {
  const int folder = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0 || ::flock(folder, LOCK_EX | LOCK_NB) == 0) return folder;
  const int error = errno;
  ::close(folder);
  errno = error;
  return -1;
}

tl::unexpected<Error> failure(int error, const fs::path& path) {
  return unexpected(ErrorCode::storage, std::strerror(error), path);
}

}  // namespace

Expected<UnfinishedFolder> UnfinishedFolder::create(const fs::path& whole) {
  for (int number = 1;; ++number) {  // ends: names are not used again
    fs::path path = whole;
    path += kUnfinished + ("-" + std::to_string(::getpid()) + "-" + std::to_string(number));
    std::error_code error;
    if (!fs::create_directory(path, error)) {
      if (error) return failure(error.value(), path);
      continue;
    }
    const int lock = lock_folder(path);
    if (lock >= 0 && fs::exists(path, error)) return UnfinishedFolder(whole, std::move(path), lock);
    if (lock >= 0) {
      ::close(lock);
    } else if (errno != EWOULDBLOCK && errno != ENOENT) {
      return failure(errno, path);
    }
    // another process took it for one that was abandoned
  }
}

UnfinishedFolder::UnfinishedFolder(fs::path whole, fs::path path, int lock)
    : whole_(std::move(whole)), path_(std::move(path)), lock_(lock) {}

UnfinishedFolder::UnfinishedFolder(UnfinishedFolder&& other) noexcept
    : whole_(std::move(other.whole_)), path_(std::exchange(other.path_, {})), lock_(std::exchange(other.lock_, -1)) {}

UnfinishedFolder::~UnfinishedFolder() {
  std::error_code unknown;
  if (!path_.empty()) fs::remove_all(path_, unknown);
  if (lock_ >= 0) ::close(lock_);
}

Expected<void> UnfinishedFolder::finish() {
  std::error_code error;
  if (fs::exists(whole_, error)) return unexpected(ErrorCode::conflict, "is there already", whole_);
  fs::rename(path_, whole_, error);
  if (error == std::errc::directory_not_empty || error == std::errc::file_exists)
    return unexpected(ErrorCode::conflict, "is there already", whole_);
  if (error) return failure(error.value(), whole_);
  path_.clear();
  return synchronise_folder(whole_.parent_path());
}

fs::path UnfinishedFolder::abandon(const fs::path& folder) {
  fs::path away = folder;
  away += kUnfinished;
  fs::rename(folder, away);
  return away;
}

void UnfinishedFolder::remove_abandoned(const fs::path& folder, const std::string& name) {
  std::error_code unknown;
  for (const auto& entry : fs::directory_iterator(folder, unknown)) {
    const fs::path found = entry.path().filename();
    if (!found.extension().string().starts_with(kUnfinished)) continue;
    if (!name.empty() && found.stem() != name) continue;
    const int lock = lock_folder(entry.path());
    if (lock < 0) continue;
    fs::remove_all(entry.path(), unknown);
    ::close(lock);
  }
}

}  // namespace race::server
