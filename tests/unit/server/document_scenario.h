// A scenario of changes of documents, and what a store holds after each, for tests of disks that fail and files that
// are damaged.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/value/json.h"
#include "tests/unit/server/document_store.h"

namespace race::server {

/// Of each document its revisions, the newest first, with their texts.
using Content = std::map<std::string, std::vector<std::pair<Revision, std::string>>>;

/// All that can be read; the first error, if something cannot.
inline Checked<Content> content_of(Documents& documents) {
  Content out;
  const auto heads = documents.list();
  if (!heads) return tl::unexpected(heads.error());
  for (const Revision& head : *heads) {
    const auto revisions = documents.revisions(head.document, {}, 100);
    if (!revisions) return tl::unexpected(revisions.error());
    for (const Revision& revision : *revisions) {
      const auto entry = documents.entry(head.document, revision.number);
      if (!entry) return tl::unexpected(entry.error());
      EXPECT_EQ(entry->revision, revision);
      out[head.document].emplace_back(revision, to_json(entry->document));
    }
    EXPECT_EQ(revisions->front(), head);
  }
  return out;
}

/// What a server reads that begins on the file: all of it, or why not.
inline Checked<Content> read_store(const std::string& path) try {
  const auto one = [](Error error) { return tl::unexpected(std::vector<Error>{std::move(error)}); };
  const auto file = sqlite::open(path);
  if (auto sound = sqlite::check(*file); !sound) return one(sound.error());
  if (auto done = sqlite::migrate(*file, store_migrations()); !done) return one(done.error());
  auto documents = Documents::open(path);
  if (!documents) return one(documents.error());
  return content_of(**documents);
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(std::vector<Error>{sqlite::error_of(exception, "cannot open")});
}

using Step = std::function<Checked<DocumentEntry>(Documents&)>;

/// Puts, drafts, restores, branches and edits; texts from one page to several.
inline std::vector<Step> scenario() {
  const auto task = [](std::size_t length) {
    return R"({"rcm": 1, "root": {"state": "R", "doc": ")" + std::string(length, 'x') + "\"}}";
  };
  return {
      [](Documents& d) {
        return d.put("task", kTask, {"Ada", "begin", 1});
      },
      [](Documents& d) {
        return d.put("task", kDraft, {"Ada", "", 2}, as_draft());
      },
      [=](Documents& d) {
        return d.put("large", task(20'000), {"Bob", "", 3});
      },
      [](Documents& d) {
        return d.put("task", kTornDraft, {"", "", 4}, as_draft());
      },
      [](Documents& d) {
        return d.restore("task", 1, {"Ada", "it was better", 5});
      },
      [](Documents& d) {
        return d.branch("task", {"mine", 2}, {"Bob", "", 6});
      },
      [=](Documents& d) {
        return d.put("large", task(9'000), {"Bob", "", 7});
      },
      [=](Documents& d) {
        return d.put("mine", task(10), {"Bob", "", 8});
      },
      [](Documents& d) {
        return edit_doc(d, "mine", "an edit", {"Bob", "", 9});
      },
      [](Documents& d) {
        return edit_doc(d, "mine", std::string(5'000, 'y'), {"Ada", "stored whole", 10});
      },
      [](Documents& d) {
        return edit_doc(d, "mine", "another edit", {"Ada", "", 11});
      },
  };
}

}  // namespace race::server
