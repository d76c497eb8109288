// check_log: whether the write-ahead log of an SQLite file is whole. SQLite itself takes a damaged frame for the end of
// the log, and drops every transaction after it without a word.
//
// Threads: any.
#pragma once

#include <string>

#include "core/value/expected.h"

namespace race::sqlite {

/// Reads the log of the file at `database_path`, before the file is opened; no log is sound. Error `corrupt`, with the
/// path of the log: it is damaged, and SQLite would drop transactions that were committed. `storage`: the disk does not
/// give it.
///
/// Every transaction is synchronised before the next one begins (file.h), so that a loss of power can leave the last
/// one torn, and no other: a frame is damaged if there is a transaction after its own. What SQLite drops for good
/// reason is sound: a torn last transaction, frames of an earlier log, and a log of which the header is damaged if the
/// database has all of it (a reset that the disk did not finish). Limit: damage of the last transaction cannot be told
/// from a torn one.
Expected<void> check_log(const std::string& database_path);

}  // namespace race::sqlite
