#include "server/accounts/audit_log.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <array>
#include <utility>

#include "core/language/primitives/utf8.h"
#include "server/store/digest_column.h"
#include "services/sqlite/digest.h"
#include "services/sqlite/file.h"
#include "services/sqlite/log_check.h"
#include "services/sqlite/write_transaction.h"

namespace race::server {
namespace {

using sqlite::Digest;

// chain: sha256_of(that of the row before, the fields); of the first row that is kept, of the one before it that is
// not.
void make_table(SQLite::Database& file) {
  file.exec(
      "CREATE TABLE audit (number INTEGER PRIMARY KEY AUTOINCREMENT, time INTEGER NOT NULL, account TEXT NOT NULL,"
      " address TEXT NOT NULL, action TEXT NOT NULL, outcome TEXT NOT NULL, chain BLOB NOT NULL)");
}

constexpr std::array<sqlite::Migration, 1> kAuditMigrations = {make_table};

Digest chain_of(const Digest& before, const AuditEntry& entry) {
  return sqlite::sha256_of({sqlite::bytes(before), std::to_string(entry.number), std::to_string(entry.time),
                            entry.account, entry.address, entry.action, entry.outcome});
}

AuditEntry entry_in(SQLite::Statement& row) {
  return {row.getColumn(0).getInt64(),  row.getColumn(1).getInt64(),  row.getColumn(2).getString(),
          row.getColumn(3).getString(), row.getColumn(4).getString(), row.getColumn(5).getString()};
}

tl::unexpected<Error> damaged(std::int64_t number) {
  return unexpected(ErrorCode::corrupt, "the audit log is damaged", std::to_string(number));
}

struct Last {
  std::int64_t number = 0;
  Digest chain = {};
};

Last last_of(SQLite::Database& file) {
  SQLite::Statement select(file, "SELECT number, chain FROM audit ORDER BY number DESC LIMIT 1");
  if (!select.executeStep()) return {};
  return {select.getColumn(0).getInt64(), digest_in(select, 1)};
}

// That each row follows the one before; the first may be any.
Expected<void> check_chain(SQLite::Database& file) {
  SQLite::Statement select(file, "SELECT * FROM audit ORDER BY number");
  std::optional<Last> before;
  while (select.executeStep()) {
    const AuditEntry entry = entry_in(select);
    const Digest chain = digest_in(select, 6);
    if (before && (entry.number != before->number + 1 || chain != chain_of(before->chain, entry)))
      return damaged(entry.number);
    before = Last{entry.number, chain};
  }
  return {};
}

void insert(SQLite::Database& file, const AuditEntry& entry, const Digest& chain) {
  SQLite::Statement insert(file, "INSERT INTO audit VALUES (?, ?, ?, ?, ?, ?, ?)");
  insert.bind(1, entry.number);
  insert.bind(2, entry.time);
  insert.bind(3, entry.account);
  insert.bind(4, entry.address);
  insert.bind(5, entry.action);
  insert.bind(6, entry.outcome);
  bind_digest(insert, 7, chain);
  insert.exec();
}

void remove_oldest(SQLite::Database& file, std::int64_t last) {
  SQLite::Statement remove(file, "DELETE FROM audit WHERE number <= ?");
  remove.bind(1, last - AuditLog::kMost);
  remove.exec();
}

}  // namespace

AuditLog::AuditLog(std::unique_ptr<SQLite::Database> file, Failed failed)
    : failed_(std::move(failed)), file_(std::move(file)) {}

AuditLog::~AuditLog() { close(); }

void AuditLog::close() {
  bool was_closed = false;
  {
    const services::MutexLock lock(queue_mutex_);
    was_closed = std::exchange(closed_, true);
  }
  closing_.notify_all();
  pool_.end();
  if (const std::size_t lost = waiting(); lost > 0 && !was_closed)
    failed_({ErrorCode::storage, std::to_string(lost) + " rows of the audit log are lost"});
}

Expected<std::unique_ptr<AuditLog>> AuditLog::open(const std::string& path, Failed failed) try {
  if (auto sound = sqlite::check_log(path); !sound) return tl::unexpected(std::move(sound).error());
  auto file = sqlite::open(path);
  if (auto migrated = sqlite::migrate(*file, kAuditMigrations); !migrated)
    return tl::unexpected(std::move(migrated).error());
  if (auto sound = check_chain(*file); !sound) return tl::unexpected(std::move(sound).error());
  return std::unique_ptr<AuditLog>(new AuditLog(std::move(file), std::move(failed)));
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot open the audit log"));
}

bool AuditLog::has_room() const {
  const services::MutexLock lock(queue_mutex_);
  return queue_.size() + writing_ < kMostWaiting;
}

void AuditLog::append(AuditEntry entry) {
  entry.action = language::utf8::prefix(entry.action, kLongest);
  const services::MutexLock lock(queue_mutex_);
  if (closed_ || queue_.size() + writing_ >= 2 * kMostWaiting)
    return;  // of what is not refused meanwhile: stops of the cell
  queue_.push_back(std::move(entry));
  if (!at_work_) at_work_ = pool_.post([this] { write_queue(); });
}

// Rows that could not be written go back to the front. That moves nodes of lists: it needs no memory.
void AuditLog::write_queue() {
  bool has_failed = false;
  for (;;) {
    std::list<AuditEntry> entries;
    bool is_last_try = false;
    {
      const services::MutexLock lock(queue_mutex_);
      at_work_ = !queue_.empty();
      if (!at_work_) return;
      entries.swap(queue_);
      writing_ = entries.size();
      is_last_try = closed_;
    }
    const std::optional<Error> error = write(entries);
    if (!error) entries.clear();
    if (error && !has_failed) failed_(*error);
    has_failed = error.has_value();
    const services::MutexLock lock(queue_mutex_);
    queue_.splice(queue_.begin(), entries);
    writing_ = 0;
    if (!has_failed) continue;
    if (is_last_try) return;
    closing_.wait_for(queue_mutex_, kRetry, [this]() REQUIRES(queue_mutex_) { return closed_; });
  }
}

std::optional<Error> AuditLog::write(std::list<AuditEntry>& entries) try {
  const services::MutexLock lock(mutex_);
  sqlite::WriteTransaction transaction(*file_);
  Last last = last_of(*file_);
  for (AuditEntry& entry : entries) {
    entry.number = last.number + 1;
    last = {entry.number, chain_of(last.chain, entry)};
    insert(*file_, entry, last.chain);
  }
  remove_oldest(*file_, last.number);
  transaction.commit();
  return std::nullopt;
} catch (const SQLite::Exception& exception) {
  return sqlite::error_of(exception, "cannot write to the audit log");
} catch (const std::exception& exception) {  // no memory
  return Error{ErrorCode::unavailable, "cannot write to the audit log: " + std::string(exception.what())};
}

Expected<AuditLog::Page> AuditLog::list(std::optional<std::int64_t> before, std::int64_t limit) try {
  const services::MutexLock lock(mutex_);
  SQLite::Statement select(*file_, "SELECT * FROM audit WHERE number < ? ORDER BY number DESC LIMIT ?");
  select.bind(1, before.value_or(INT64_MAX));
  select.bind(2, limit);
  Page page;
  while (select.executeStep()) page.entries.push_back(entry_in(select));
  if (page.entries.size() == static_cast<std::size_t>(limit) && page.entries.back().number > 1)
    page.next = page.entries.back().number;
  return page;
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot read the audit log"));
}

}  // namespace race::server
