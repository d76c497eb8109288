#include "server/store/pictures.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include "core/value/json.h"
#include "server/store/digest_column.h"
#include "server/store/schema.h"
#include "server/store/thinning.h"
#include "services/sqlite/file.h"
#include "services/sqlite/write_transaction.h"

namespace race::server {
namespace {

constexpr ThinnedTable kTable{"picturing", "picture", "jpeg"};

sqlite::Digest digest_of(RunId run, std::int64_t number, const Picture& picture) {
  return sqlite::sha256_of({std::to_string(run), std::to_string(number), picture.service, std::to_string(picture.step),
                            to_json(Value(picture.time)), picture.jpeg});
}

void write_picture(SQLite::Database& file, RunId run, std::int64_t number, const Picture& picture) {
  SQLite::Statement insert(file, "INSERT OR REPLACE INTO picture VALUES (?, ?, ?, ?, ?, ?, ?)");
  insert.bind(1, sqlite::integer(run));
  insert.bind(2, number);
  insert.bind(3, picture.service);
  insert.bind(4, sqlite::integer(picture.step));
  insert.bind(5, picture.time);
  insert.bind(6, picture.jpeg);
  bind_digest(insert, 7, digest_of(run, number, picture));
  insert.exec();
}

// A row `number, service, step, time, jpeg, digest`.
Expected<Picture> read_row(SQLite::Statement& row, RunId run) {
  const std::int64_t number = row.getColumn(0).getInt64();
  Picture picture{row.getColumn(1).getString(), static_cast<std::uint64_t>(row.getColumn(2).getInt64()),
                  row.getColumn(3).getDouble(), row.getColumn(4).getString()};
  if (digest_in(row, 5) != digest_of(run, number, picture))
    return unexpected(ErrorCode::corrupt, "a picture is damaged",
                      "runs/" + std::to_string(run) + "/pictures/" + std::to_string(number));
  return picture;
}

}  // namespace

Pictures::Pictures(std::unique_ptr<SQLite::Database> file) : file_(std::move(file)) {}
Pictures::~Pictures() = default;

Expected<std::unique_ptr<Pictures>> Pictures::open(const std::string& path) try {
  auto file = sqlite::open(path);
  if (auto done = sqlite::migrate(*file, store_migrations()); !done) return tl::unexpected(std::move(done).error());
  return std::unique_ptr<Pictures>(new Pictures(std::move(file)));
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot open the pictures"));
}

Expected<void> Pictures::append(RunId run, const std::vector<Picture>& pictures) try {
  const services::MutexLock lock(mutex_);
  sqlite::WriteTransaction transaction(*file_);
  if (!has_run(*file_, run)) return {};
  Thinning thinning = read_thinning(*file_, kTable, run);
  for (const Picture& picture : pictures) {
    const std::int64_t number = thinning.seen++;
    if (number % thinning.every != 0) continue;
    write_picture(*file_, run, number, picture);
    thinning.bytes += static_cast<std::int64_t>(picture.jpeg.size());
    if (thinning.kept() > kMost) thin_out(*file_, kTable, run, thinning);
  }
  write_thinning(*file_, kTable, run, thinning);
  transaction.commit();
  return {};
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot store pictures"));
}

Expected<std::vector<NumberedPicture>> Pictures::list(RunId run) try {
  const services::MutexLock lock(mutex_);
  SQLite::Statement select(*file_, "SELECT number, service, step, time FROM picture WHERE run = ? ORDER BY number");
  select.bind(1, sqlite::integer(run));
  std::vector<NumberedPicture> found;
  while (select.executeStep())
    found.push_back({select.getColumn(0).getInt64(),
                     {select.getColumn(1).getString(),
                      static_cast<std::uint64_t>(select.getColumn(2).getInt64()),
                      select.getColumn(3).getDouble(),
                      {}}});
  return found;
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot read pictures"));
}

Expected<Picture> Pictures::read(RunId run, std::int64_t number) try {
  const services::MutexLock lock(mutex_);
  SQLite::Statement select(*file_,
                           "SELECT number, service, step, time, jpeg, digest FROM picture"
                           " WHERE run = ? AND number = ?");
  select.bind(1, sqlite::integer(run));
  select.bind(2, number);
  if (!select.executeStep())
    return unexpected(ErrorCode::not_found, "run " + std::to_string(run) + " has no picture " + std::to_string(number));
  return read_row(select, run);
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot read pictures"));
}

Expected<std::vector<Picture>> Pictures::read_all(RunId run) try {
  const services::MutexLock lock(mutex_);
  SQLite::Statement select(*file_,
                           "SELECT number, service, step, time, jpeg, digest FROM picture"
                           " WHERE run = ? ORDER BY number");
  select.bind(1, sqlite::integer(run));
  std::vector<Picture> found;
  while (select.executeStep()) {
    ASSIGN_OR_RETURN(Picture picture, read_row(select, run));
    found.push_back(std::move(picture));
  }
  return found;
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot read pictures"));
}

}  // namespace race::server
