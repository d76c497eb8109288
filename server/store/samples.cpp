#include "server/store/samples.h"

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

constexpr ThinnedTable kTable{"sampling", "sample", "pose"};

sqlite::Digest digest_of(RunId run, std::int64_t number, std::uint64_t step, const std::string& pose) {
  return sqlite::sha256_of({std::to_string(run), std::to_string(number), std::to_string(step), pose});
}

void write_sample(SQLite::Database& file, RunId run, std::int64_t number, std::uint64_t step, const std::string& pose) {
  SQLite::Statement insert(file, "INSERT OR REPLACE INTO sample VALUES (?, ?, ?, ?, ?)");
  insert.bind(1, sqlite::integer(run));
  insert.bind(2, number);
  insert.bind(3, sqlite::integer(step));
  insert.bind(4, pose);
  bind_digest(insert, 5, digest_of(run, number, step, pose));
  insert.exec();
}

}  // namespace

Samples::Samples(std::unique_ptr<SQLite::Database> file) : file_(std::move(file)) {}
Samples::~Samples() = default;

Expected<std::unique_ptr<Samples>> Samples::open(const std::string& path) try {
  auto file = sqlite::open(path);
  if (auto done = sqlite::migrate(*file, store_migrations()); !done) return tl::unexpected(std::move(done).error());
  return std::unique_ptr<Samples>(new Samples(std::move(file)));
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot open the samples"));
}

Expected<void> Samples::append(RunId run, const std::vector<Sample>& samples) try {
  const services::MutexLock lock(mutex_);
  sqlite::WriteTransaction transaction(*file_);
  if (!has_run(*file_, run)) return {};
  Thinning thinning = read_thinning(*file_, kTable, run);
  for (const Sample& sample : samples) {
    const std::int64_t number = thinning.seen++;
    if (number % thinning.every != 0) continue;
    const std::string pose = to_json(sample.pose);
    write_sample(*file_, run, number, sample.step, pose);
    thinning.bytes += static_cast<std::int64_t>(pose.size());
    if (thinning.kept() > kMost) thin_out(*file_, kTable, run, thinning);
  }
  write_thinning(*file_, kTable, run, thinning);
  transaction.commit();
  return {};
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot store samples"));
}

Expected<std::vector<Sample>> Samples::read(RunId run) try {
  const services::MutexLock lock(mutex_);
  SQLite::Statement select(*file_, "SELECT number, step, pose, digest FROM sample WHERE run = ? ORDER BY number");
  select.bind(1, sqlite::integer(run));
  std::vector<Sample> found;
  while (select.executeStep()) {
    const std::int64_t number = select.getColumn(0).getInt64();
    const auto step = static_cast<std::uint64_t>(select.getColumn(1).getInt64());
    const std::string pose = select.getColumn(2).getString();
    auto json = parse_json(pose);
    if (digest_in(select, 3) != digest_of(run, number, step, pose) || !json)
      return unexpected(ErrorCode::corrupt, "a sample is damaged",
                        "runs/" + std::to_string(run) + "/samples/" + std::to_string(number));
    found.push_back({step, json->freeze()});
  }
  return found;
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot read samples"));
}

}  // namespace race::server
