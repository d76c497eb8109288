// A store of documents in a folder of its own, for tests.
#pragma once

#include <SQLiteCpp/Database.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "core/edit/apply.h"
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

/// What an edit makes of the last revision, stored: the root gets another `doc`.
inline Checked<DocumentEntry> edit_doc(Documents& documents, const std::string& name, const std::string& doc,
                                       const Change& change) {
  const auto last = documents.entry(name);
  if (!last) return last;
  const rcm::Document document = document_of(last);
  const edit::Edit edit{{edit::Set{document.root.meta.id, "doc", {}, Value(doc)}}};
  const auto applied = edit::apply(document, edit).value();
  const Revision next{name, last->revision.number + 1, change, {Origin::Kind::edit}, 0, doc_of(applied.document)};
  if (auto stored = documents.append_edit({next, rcm::write_document_text(applied.document).value()}, {edit}); !stored)
    return tl::unexpected(std::vector<Error>{stored.error()});
  return documents.entry(name);
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
