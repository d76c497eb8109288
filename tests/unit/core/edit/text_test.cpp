// The text of a document does not change when it is read as a tree, so that an edit changes the lines that it concerns
// and no others.
#include <gtest/gtest.h>

#include <random>

#include "core/edit/history.h"
#include "core/rcm/ids.h"
#include "tests/unit/core/edit/documents.h"
#include "tests/unit/core/edit/random_edits.h"
#include "tests/unit/core/rcm/cases.h"
#include "tests/unit/core/semantics/random_models.h"
#include "tests/unit/setting.h"

namespace race::edit {
namespace {

/// Puts entries in any order, and objects without entries, wherever a document may have them.
class RandomEntries {
 public:
  explicit RandomEntries(std::uint64_t seed) : random_(seed) {}

  void fill(rcm::Document& document) {
    fill(document.root);
    for (rcm::State& state : document.library) fill(state);
    Dict meta = entries(0);
    if (pick(2) == 0) meta.set("notes", texts());
    if (pick(2) == 0) meta.set("author", "a");
    document.meta = std::move(meta);
    document.layout = entries(0);
  }

 private:
  std::size_t pick(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }
  std::string key() { return std::string(1, static_cast<char>('a' + static_cast<int>(pick(26)))); }

  void fill(rcm::State& state) {
    fill(state.meta);
    for_each_element(state, [&](ListName, auto& element) { fill_element(element); });
  }
  void fill_element(rcm::State& state) { fill(state); }
  template <typename Element>
  void fill_element(Element& element) {
    fill(element.meta);
  }
  void fill(rcm::Meta& meta) {
    if (pick(2) == 0) meta.rest = entries(0);
  }

  Dict entries(int level) {
    Dict out;
    for (std::size_t i = pick(5); i > 0; --i) {
      const bool is_object = level < 2 && pick(3) == 0;
      out.set(key(), is_object ? Value(entries(level + 1)) : Value(static_cast<std::int64_t>(pick(9))));
    }
    return out;
  }
  Dict texts() {
    Dict out;
    for (std::size_t i = pick(4); i > 0; --i) out.set(key(), key());
    return out;
  }

  std::mt19937_64 random_;
};

rcm::Document document_with_entries(std::uint64_t seed) {
  rcm::Document out;
  out.root = semantics::RandomModels(seed).model().root;
  RandomEntries(seed).fill(out);
  rcm::give_ids(out);
  return out;
}

std::vector<rcm::Document> documents() {
  std::vector<std::filesystem::path> files;
  for (const auto& folder : rcm::cases(false)) files.push_back(folder / "model.json");
  for (const auto& entry : std::filesystem::directory_iterator(RACE_SOURCE_DIR "/deploy/demo")) {
    if (entry.path().string().ends_with(".rcm.json")) files.push_back(entry.path());
  }
  std::vector<rcm::Document> out;
  for (const auto& file : files) {
    out.push_back(rcm::read_document_text(rcm::read_text(file)).value());
    rcm::give_ids(out.back());
  }
  for (std::uint64_t seed = 0; seed < sample(300); ++seed) out.push_back(document_with_entries(seed));
  return out;
}

TEST(TextOfDocuments, IsTheSameWhenReadAsATree) {
  const auto all = documents();
  ASSERT_GT(all.size(), 50 + sample(300));
  for (const rcm::Document& document : all) {
    const std::string text = rcm::write_document_text(document).value();
    const rcm::Document as_tree = Tree::read(document).value().document();
    ASSERT_EQ(rcm::write_document_text(as_tree).value(), text);
    ASSERT_EQ(to_json(rcm::write_document(as_tree)), to_json(rcm::write_document(document)));
  }
}

TEST(TextOfDocuments, IsTheSameWhenReadAgain) {
  for (const rcm::Document& document : documents()) {
    const std::string text = rcm::write_document_text(document).value();
    const rcm::Document read = rcm::read_draft(parse_json(text).value()).document;
    ASSERT_EQ(rcm::write_document_text(read).value(), text);
    ASSERT_EQ(rcm::read_draft(rcm::write_document(document)).document, read);
  }
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> out;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) out.push_back(line);
  return out;
}

TEST(TextOfDocuments, HasOtherLinesWhereItWasEditedAlone) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const rcm::Document document = document_with_entries(seed);
    const auto before = lines_of(rcm::write_document_text(document).value());
    Tree tree = Tree::read(document).value();
    ASSERT_TRUE(apply(tree, Edit{{Set{tree.root(), "state", {}, Value("Renamed")}}}));
    const auto after = lines_of(rcm::write_document_text(tree.document()).value());
    ASSERT_EQ(after.size(), before.size());
    std::size_t changed = 0;
    for (std::size_t i = 0; i < after.size(); ++i) changed += after[i] == before[i] ? 0 : 1;
    ASSERT_EQ(changed, 1U) << "seed " << seed;
  }
}

}  // namespace
}  // namespace race::edit
