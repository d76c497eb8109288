// The tables of a database file, and how those of older versions become them.
#pragma once

#include <span>
#include <string_view>

#include "services/sqlite/digest.h"
#include "services/sqlite/file.h"

namespace race::database {

std::span<const sqlite::Migration> migrations();

/// The digest that a row of `record` has; its table hash has that name, too.
inline sqlite::Digest digest_of(std::string_view key, std::string_view value) {
  return sqlite::sha256_of({key, value});
}
inline constexpr std::string_view kRecords = "record";

}  // namespace race::database
