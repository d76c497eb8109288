// SQLite files as all of ours are: a write-ahead log, every commit synchronised, migrated by version, and with failures
// as Errors. Functions throw SQLite::Exception unless they return an Expected; error_of() makes an Error of it.
//
// Threads: any; a connection belongs to one at a time.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/value/expected.h"

namespace SQLite {
class Database;
class Exception;
}  // namespace SQLite

namespace race::sqlite {

/// A connection to the file, which is made if it is not there; ":memory:" is one in memory. Other connections may hold
/// the file meanwhile, also of other processes: a write waits for theirs, up to ten seconds.
std::unique_ptr<SQLite::Database> open(const std::string& path);
/// One that cannot write. Requires that the file is there.
std::unique_ptr<SQLite::Database> open_to_read(const std::string& path);

/// Makes version `to` of a file of version `to` - 1 (`user_version`; that of a new file is 0). In the transaction of
/// migrate().
using Migration = void (*)(SQLite::Database& file);
/// Brings the file to the last of `migrations`, the first of which makes version 1, in one transaction: whatever
/// happens, the file is the old one or the new one.
/// Errors: `version` (a newer version of the program wrote it), those of error_of().
Expected<void> migrate(SQLite::Database& file, std::span<const Migration> migrations);

/// Whether the structure of the file is sound. Reads the whole file. Errors: `corrupt` with what SQLite found first,
/// `storage`: the disk does not give it.
Expected<void> check(SQLite::Database& file);

/// A count or number of ours as SQLite stores it: 64 bits with a sign.
constexpr std::int64_t integer(std::uint64_t number) { return static_cast<std::int64_t>(number); }

/// `what` failed: `corrupt` (the file is damaged or no database), `storage` (the disk is full, fails or is read-only),
/// else `io`.
Error error_of(const SQLite::Exception& exception, std::string_view what);

}  // namespace race::sqlite
