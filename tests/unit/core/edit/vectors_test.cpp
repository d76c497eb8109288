// The test vectors of api/examples/edits, which the clients read, too: what an edit makes of a document.
#include <filesystem>

#include "core/edit/compound.h"
#include "core/edit/history.h"
#include "tests/unit/core/edit/documents.h"
#include "tests/unit/core/rcm/cases.h"

namespace race::edit {
namespace {

struct Vector {
  std::string name;
  Value json;
  const Value& operator[](std::string_view field) const { return *json.find(field); }
};

std::vector<Vector> vectors(std::string_view prefix) {
  std::vector<Vector> out;
  for (const auto& entry : std::filesystem::directory_iterator(RACE_SOURCE_DIR "/api/examples/edits")) {
    const std::string name = entry.path().filename();
    if (!name.starts_with(prefix)) continue;
    out.push_back({name, parse_json(rcm::read_text(entry.path())).value()});
  }
  EXPECT_GT(out.size(), 4U);
  return out;
}

std::string text_of(const Value& document) { return rcm::format_document(document_of(document)); }

void expect_applied(const Vector& vector) {
  const auto applied = apply(document_of(vector["document"]), read_edit(vector["edit"]).value());
  ASSERT_TRUE(applied) << to_string(applied.error());
  EXPECT_EQ(rcm::format_document(applied->document), text_of(vector["result"]));
  EXPECT_EQ(to_json(write_edit(applied->inverse), 1), to_json(vector["inverse"], 1));
  const auto back = apply(applied->document, applied->inverse);
  ASSERT_TRUE(back);
  EXPECT_EQ(rcm::format_document(back->document), text_of(vector["document"]));
}

TEST(Vectors, OfEditsThatAreApplied) {
  for (const Vector& vector : vectors("apply.")) {
    SCOPED_TRACE(vector.name);
    expect_applied(vector);
  }
}

/// `compound` as api/schemas/edit_request.json has it.
Expected<Edit> make_edit(const Tree& tree, const Value& compound, const std::string& seed) {
  const auto text = [&](const char* field) { return compound.find(field)->as_string(); };
  const std::string kind = text("kind");
  if (kind == "rename") return rename(tree, text("id"), text("name"));
  if (kind == "connect") return connect(tree, text("from"), text("to"));
  if (kind == "ungroup") return ungroup(tree, text("id"));
  if (kind == "extract") return extract(tree, text("id"), text("name"), seed);
  Ids ids;
  for (const Value& id : compound.find("ids")->as_list()) ids.push_back(id.as_string());
  return group(tree, ids, text("name"), seed);
}

TEST(Vectors, OfCompoundEdits) {
  for (const Vector& vector : vectors("compound.")) {
    SCOPED_TRACE(vector.name);
    const Value* seed = vector.json.find("seed");
    const auto edit = make_edit(Tree::read(document_of(vector["document"])).value(), vector["compound"],
                                seed ? seed->as_string() : std::string());
    ASSERT_TRUE(edit) << to_string(edit.error());
    EXPECT_EQ(to_json(write_edit(*edit), 1), to_json(vector["edit"], 1));
    expect_applied(vector);
  }
}

TEST(Vectors, OfEditsThatAreRefused) {
  for (const Vector& vector : vectors("refuse.")) {
    SCOPED_TRACE(vector.name);
    const auto applied = apply(document_of(vector["document"]), read_edit(vector["edit"]).value());
    ASSERT_FALSE(applied);
    EXPECT_EQ(applied.error().path, vector["error"].find("path")->as_string());
    EXPECT_EQ(name(applied.error().code), vector["error"].find("code")->as_string());
  }
}

Value rejection_json(const Rejection& rejection) {
  Dict out{{"path", rejection.error.path}, {"code", name(rejection.error.code)}};
  if (rejection.revision > 0) {
    out.set("author", rejection.author);
    out.set("revision", static_cast<std::int64_t>(rejection.revision));
  }
  return out;
}

TEST(Vectors, OfHistories) {
  for (const Vector& vector : vectors("history.")) {
    SCOPED_TRACE(vector.name);
    History history(Tree::read(document_of(vector["document"])).value());
    for (const Value& step : vector["steps"].as_list()) {
      const std::string& author = step.find("author")->as_string();
      const auto result = step.find("undo")   ? history.undo(author)
                          : step.find("redo") ? history.redo(author)
                                              : history.apply(author, Revision(step.find("base")->as_integer()),
                                                              read_edit(*step.find("edit")).value());
      const Value expected = step.find("accepted") ? *step.find("accepted") : *step.find("rejected");
      const Value found = result ? write_edit((*result)->edit) : rejection_json(result.error());
      EXPECT_EQ(to_json(found, 1), to_json(expected, 1));
    }
    EXPECT_EQ(edit::text_of(history.tree()), text_of(vector["result"]));
  }
}

}  // namespace
}  // namespace race::edit
