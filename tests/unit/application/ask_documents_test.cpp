#include "server/commands/ask_documents.h"

#include <gtest/gtest.h>

#include "core/value/json.h"
#include "server/commands/document_file.h"

namespace race::server {
namespace {

TEST(InOneLine, NothingEndsALineOrChangesATerminal) {
  EXPECT_EQ(in_one_line("a\nb\x1b[2J\x7f"), "a b [2J ");
  EXPECT_EQ(in_one_line("\xc2\x9b"
                        "2J \xe2\x80\xae"
                        "x"),
            " 2J  x")
      << "C1 and the direction of writing";
  EXPECT_EQ(in_one_line("gr\xc3\xbc\xc3\x9f"), "gr\xc3\xbc\xc3\x9f");
  EXPECT_EQ(in_one_line("\x9b"), "\\x9b") << "no UTF-8";
}

Value json(const char* text) { return parse_json(text).value(); }

TEST(AddPage, GivesWhereTheNextOneBegins) {
  DocumentList list;
  EXPECT_EQ(
      add_page(json(R"({"documents": [{"name": "a", "revision": 3, "errors": 0, "doc": "x"}], "next": "a"})"), "", list)
          .value(),
      "a");
  EXPECT_EQ(
      add_page(json(R"({"documents": [{"name": "b", "revision": 1, "errors": 201}], "damaged": [{}]})"), "a", list)
          .value(),
      "");
  ASSERT_EQ(list.documents.size(), 2U);
  EXPECT_EQ(list.documents[1].errors, 201);
  EXPECT_EQ(list.json.size() + list.damaged.size(), 3U);
}

TEST(AddPage, RefusesAListWithoutAnEndAndWhatIsNone) {
  DocumentList list;
  EXPECT_EQ(add_page(json(R"({"documents": [], "next": "a"})"), "a", list).error().code, ErrorCode::io);
  for (const char* none : {"[]", "{}", R"({"documents": [{"name": 1, "revision": 1, "errors": 0}]})"})
    EXPECT_EQ(add_page(json(none), "", list).error().code, ErrorCode::io) << none;
}

TEST(ReadDocumentEntry, HasTheTextOfAFile) {
  const auto entry = read_document_entry(json(R"({"revision": 2, "document": {"root": {"state": "R"}, "rcm": 1}})"));
  ASSERT_TRUE(entry);
  EXPECT_EQ(entry->revision, 2);
  EXPECT_EQ(entry->text, document_text(json(R"({"rcm": 1, "root": {"state": "R"}})")));
  for (const char* none : {"{}", R"({"revision": 0, "document": {}})", R"({"revision": 1, "document": []})"})
    EXPECT_EQ(read_document_entry(json(none)).error().code, ErrorCode::io) << none;
}

TEST(DocumentText, OfADraftOfAnotherShapeIsJson) {
  EXPECT_EQ(document_text(json(R"({"rcm": "x"})")), "{\n  \"rcm\": \"x\"\n}\n");
}

TEST(DocumentNameOf, IsThatOfTheFile) {
  EXPECT_EQ(document_name_of("models/pick-2.rcm.json").value(), "pick-2");
  EXPECT_EQ(document_file_name("pick-2"), "pick-2.rcm.json");
  for (const char* file : {"pick.json", ".rcm.json", "a b.rcm.json", "models/", "", "pick.rcm.json/"})
    EXPECT_EQ(document_name_of(file).error().code, ErrorCode::name) << file;
}

}  // namespace
}  // namespace race::server
