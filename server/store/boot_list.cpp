#include "server/store/boot_list.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <set>

#include "core/value/json.h"
#include "services/sqlite/digest.h"
#include "services/sqlite/file.h"
#include "services/sqlite/write_transaction.h"

namespace race::server {
namespace {

// Of the row at `position`, from 0.
sqlite::Digest digest_of(std::size_t position, const std::string& document, const std::string& arguments) {
  return sqlite::sha256_of({std::to_string(position), document, arguments});
}

Expected<BootEntry> read(std::size_t position, SQLite::Statement& row) {
  const std::string document = row.getColumn(0), arguments = row.getColumn(1), digest = row.getColumn(2).getString();
  const auto damaged = [&] {
    return unexpected(ErrorCode::corrupt, "the boot list is damaged", "entries/" + std::to_string(position));
  };
  if (row.getColumn(3).getInt64() != static_cast<std::int64_t>(position)) return damaged();
  if (digest != sqlite::bytes(digest_of(position, document, arguments))) return damaged();
  const auto value = parse_json(arguments);
  if (!value || !value->is_dict()) return damaged();
  return BootEntry{document, value->as_dict()};
}

}  // namespace

BootList::BootList(std::unique_ptr<SQLite::Database> file) : file_(std::move(file)) {}
BootList::~BootList() = default;

Expected<std::unique_ptr<BootList>> BootList::open(const std::string& path) try {
  return std::unique_ptr<BootList>(new BootList(sqlite::open(path)));
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot open the boot list"));
}

Expected<void> BootList::check(const std::vector<BootEntry>& entries) {
  if (entries.size() > kMost)
    return unexpected(ErrorCode::too_large, "there may be " + std::to_string(kMost) + " entries", "entries");
  std::set<std::string_view> documents;
  for (const BootEntry& entry : entries)
    if (const std::string place = std::to_string(documents.size()); !documents.insert(entry.document).second)
      return unexpected(ErrorCode::duplicate, '`' + entry.document + "` stands twice",
                        "entries/" + place + "/document");
  return {};
}

Expected<std::vector<BootEntry>> BootList::get() try {
  const services::MutexLock lock(mutex_);
  SQLite::Statement select(*file_, "SELECT document, arguments, digest, position FROM boot ORDER BY position");
  std::vector<BootEntry> entries;
  while (select.executeStep()) {
    ASSIGN_OR_RETURN(BootEntry entry, read(entries.size(), select));
    entries.push_back(std::move(entry));
  }
  return entries;
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot read the boot list"));
}

Expected<void> BootList::set(const std::vector<BootEntry>& entries) try {
  if (auto fine = check(entries); !fine) return fine;
  const services::MutexLock lock(mutex_);
  sqlite::WriteTransaction transaction(*file_);
  file_->exec("DELETE FROM boot");
  SQLite::Statement insert(*file_, "INSERT INTO boot VALUES (?, ?, ?, ?)");
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::string arguments = to_json(Value(entries[i].arguments));
    const sqlite::Digest digest = digest_of(i, entries[i].document, arguments);
    insert.bind(1, sqlite::integer(i));
    insert.bind(2, entries[i].document);
    insert.bind(3, arguments);
    insert.bind(4, digest.data(), static_cast<int>(digest.size()));
    insert.exec();
    insert.reset();
  }
  transaction.commit();
  return {};
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot store the boot list"));
}

}  // namespace race::server
