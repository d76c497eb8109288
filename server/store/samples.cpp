#include "server/store/samples.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <algorithm>

#include "core/value/json.h"
#include "server/store/digest_column.h"
#include "server/store/schema.h"
#include "services/sqlite/file.h"
#include "services/sqlite/write_transaction.h"

namespace race::server {
namespace {

// How far the samples of a run have come. `every` is a power of two; kept are those whose number it divides.
struct Sampling {
  std::int64_t seen = 0, every = 1, bytes = 0;
  std::size_t kept() const { return static_cast<std::size_t>((seen + every - 1) / every); }
};

bool has_run(SQLite::Database& file, RunId run) {
  SQLite::Statement select(file, "SELECT 1 FROM run WHERE id = ?");
  select.bind(1, sqlite::integer(run));
  return select.executeStep();
}

Sampling read_sampling(SQLite::Database& file, RunId run) {
  SQLite::Statement select(file, "SELECT seen, every, bytes FROM sampling WHERE run = ?");
  select.bind(1, sqlite::integer(run));
  if (!select.executeStep()) return {};
  // A damaged row costs samples, no more.
  return {std::max<std::int64_t>(0, select.getColumn(0).getInt64()),
          std::max<std::int64_t>(1, select.getColumn(1).getInt64()), select.getColumn(2).getInt64()};
}

void write_sampling(SQLite::Database& file, RunId run, const Sampling& sampling) {
  SQLite::Statement insert(file, "INSERT OR REPLACE INTO sampling VALUES (?, ?, ?, ?)");
  insert.bind(1, sqlite::integer(run));
  insert.bind(2, sampling.seen);
  insert.bind(3, sampling.every);
  insert.bind(4, sampling.bytes);
  insert.exec();
}

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

// Drops every second one.
void thin(SQLite::Database& file, RunId run, Sampling& sampling) {
  sampling.every *= 2;
  SQLite::Statement remove(file, "DELETE FROM sample WHERE run = ? AND number % ? <> 0");
  remove.bind(1, sqlite::integer(run));
  remove.bind(2, sampling.every);
  remove.exec();
  SQLite::Statement sum(file, "SELECT coalesce(sum(length(pose)), 0) FROM sample WHERE run = ?");
  sum.bind(1, sqlite::integer(run));
  sum.executeStep();
  sampling.bytes = sum.getColumn(0).getInt64();
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
  Sampling sampling = read_sampling(*file_, run);
  for (const Sample& sample : samples) {
    const std::int64_t number = sampling.seen++;
    if (number % sampling.every != 0) continue;
    const std::string pose = to_json(sample.pose);
    write_sample(*file_, run, number, sample.step, pose);
    sampling.bytes += static_cast<std::int64_t>(pose.size());
    if (sampling.kept() > kMost) thin(*file_, run, sampling);
  }
  write_sampling(*file_, run, sampling);
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
