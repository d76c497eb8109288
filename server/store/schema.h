// The tables of race.sqlite, and how those of older versions become them. Each row has the digest of its fields
// (services/sqlite/digest.h): one that is damaged is named, never used.
#pragma once

#include <span>

#include "services/sqlite/file.h"

namespace race::server {

std::span<const sqlite::Migration> store_migrations();

}  // namespace race::server
