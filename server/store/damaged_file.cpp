#include "server/store/damaged_file.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>

#include "services/sqlite/file.h"
#include "services/sqlite/log_check.h"

namespace race::server {
namespace {

namespace fs = std::filesystem;

// To read alone: a writer would take over what its log has.
Expected<void> check(const fs::path& path) try {
  if (auto whole = sqlite::check_log(path); !whole) return whole;
  return sqlite::check(*sqlite::open_to_read(path));
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot check " + path.string()));
}

}  // namespace

// The log first: SQLite would take one that is left alone for that of the new file.
Expected<void> set_aside_if_damaged(const fs::path& path, const std::string& time) try {
  if (!fs::exists(path)) return {};
  if (auto sound = check(path); sound || sound.error().code != ErrorCode::corrupt) return sound;
  const std::string old = path, aside = old + ".damaged-" + time;
  if (fs::exists(old + "-wal")) fs::rename(old + "-wal", aside + "-wal");
  fs::remove(old + "-shm");  // made again from the log
  fs::rename(old, aside);
  return {};
} catch (const fs::filesystem_error& error) {
  return unexpected(ErrorCode::storage, error.code().message(), error.path1());
}

}  // namespace race::server
