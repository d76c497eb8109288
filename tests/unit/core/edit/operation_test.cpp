// Edits as JSON.
#include "core/edit/operation.h"

#include "tests/unit/core/edit/documents.h"

namespace race::edit {
namespace {

/// The violations of an edit with these operations, as `path: code`.
std::string violations(const std::string& operations) {
  const auto edit = read_edit(Dict{{"operations", json(operations)}});
  std::string out;
  if (edit) return out;
  for (const Error& error : edit.error())
    out += (out.empty() ? "" : ", ") + error.path + ": " + std::string(name(error.code));
  return out;
}

TEST(ReadEdit, ReadsWhatWasWritten) {
  const Edit edit{{Insert{{"r", ListName::children, "a"}, json("{'state': 'N', 'meta': {'id': 'n'}}")}, Remove{"a"},
                   Move{"b", {"", ListName::library, {}}}, Set{"", "layout", "a", json("{'x': 1.0}")},
                   Set{"b", "first", {}, {}}, Set{"p", "value", {}, Value()}}};
  EXPECT_EQ(read_edit(write_edit(edit)).value(), edit);
}

TEST(ReadEdit, NamesTheFieldThatIsWrong) {
  EXPECT_EQ(violations("[{'op':'remove','id':'no id'}]"), "operations/0/id: name");
  EXPECT_EQ(violations("[{'op':'remove','id':''}]"), "operations/0/id: name");
  EXPECT_EQ(violations("[{'op':'remove'}, {'op':'set','id':1,'field':''}]"),
            "operations/0/id: missing, operations/1/id: type");
  EXPECT_EQ(violations("[{'op':'move','id':'a','parent':'b','list':'nodes'}]"), "operations/0/list: name");
  EXPECT_EQ(violations("[{'op':'insert','parent':'','list':'library','after':''}]"),
            "operations/0/after: name, operations/0/node: missing");
  EXPECT_EQ(violations("[{'op':'copy','id':'a'}]"), "operations/0/op: name, operations/0/id: unknown_field");
  EXPECT_EQ(violations("[{'op':'remove','id':'a','more':1}]"), "operations/0/more: unknown_field");
  EXPECT_EQ(violations("[1, {}]"), "operations/0: type, operations/1/op: missing");
  EXPECT_EQ(violations("1"), "operations: type");
}

TEST(ReadEdit, RefusesTooManyOperations) {
  const auto edit = [](std::size_t count) {
    return read_edit(Dict{{"operations", List(count, Dict{{"op", "remove"}, {"id", "a"}})}});
  };
  EXPECT_TRUE(edit(kMaxOperations));
  EXPECT_EQ(edit(kMaxOperations + 1).error().front().code, ErrorCode::too_large);
}

}  // namespace
}  // namespace race::edit
