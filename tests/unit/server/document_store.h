// A store of documents in a folder of its own, for tests.
#pragma once

#include <SQLiteCpp/Database.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "core/rcm/document.h"
#include "server/store/documents.h"
#include "server/store/schema.h"
#include "services/sqlite/file.h"
#include "tests/unit/server/bench.h"

namespace race::server {

inline constexpr const char* kTask =
    R"({"rcm": 1, "root": {"state": "R", "children": [{"state": "A"}, {"state": "B"}]}})";
/// It has one violation, of a constraint: a draft that is whole.
inline constexpr const char* kDraft =
    R"({"rcm": 1, "root": {"state": "R", "first": "Nobody", "children": [{"state": "A"}]}})";
/// Its shape is wrong.
inline constexpr const char* kTornDraft = R"({"rcm": 1,   "root": {"state": "R", "children": [{}], "more": 1}})";

class DocumentStore : public testing::Test {
 protected:
  std::string path() const { return folder_ / "race.sqlite"; }
  /// Migrates, as DataFolder does.
  std::unique_ptr<Documents> open(Documents::Limits limits = {}) const {
    EXPECT_TRUE(sqlite::migrate(*sqlite::open(path()), store_migrations()));
    return Documents::open(path(), limits).value();
  }

  const TemporaryFolder place_;
  const std::filesystem::path folder_ = place_.path;
};

inline Documents::Put as_draft() { return {.draft = true, .seen = {}}; }

inline rcm::Document document_of(const Checked<DocumentEntry>& entry) {
  return rcm::read_document(entry.value().document).value();
}

inline std::string id_of(const rcm::Document& document, std::size_t child) {
  return std::get<rcm::State>(document.root.children.at(child)).meta.id;
}

/// Its only error; fails if it has none.
template <typename T>
Error error_of(const Checked<T>& result) {
  EXPECT_FALSE(result);
  if (result) return {};
  EXPECT_EQ(result.error().size(), 1U);
  return result.error().front();
}

}  // namespace race::server
