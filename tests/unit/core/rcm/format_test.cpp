// The text of documents as files hold it.
#include <gtest/gtest.h>

#include "core/rcm/document.h"
#include "core/rcm/ids.h"
#include "core/value/json.h"

namespace race::rcm {
namespace {

Document document_of(std::string_view root) {
  return read_document_text(R"({"rcm": 1, "root": )" + std::string(root) + "}").value();
}

TEST(FormatDocument, PutsWhatIsSmallOnOneLineAndEachElementOnItsOwn) {
  EXPECT_EQ(format_document(document_of(
                R"({"state": "Root", "parameters": [{"name": "a", "value": [1, 2.0]}], "children": [{"state": "A",
                   "ports": [{"name": "done", "when": "True", "to": "B"}]}, {"state": "B"}], "first": "A"})")),
            R"({
  "rcm": 1,
  "root": {
    "state": "Root",
    "parameters": [
      {"name": "a", "value": [1, 2.0]}
    ],
    "children": [
      {
        "state": "A",
        "ports": [
          {"name": "done", "when": "True", "to": "B"}
        ]
      },
      {
        "state": "B"
      }
    ],
    "first": "A"
  }
}
)");
}

TEST(FormatDocument, GivesEachServicePlaceAndNoteOneLine) {
  const Document document = read_document_text(R"({"rcm": 1, "services": {"b": "x", "a": "y"},
      "root": {"state": "R", "meta": {"icon": "hand", "id": "r"}},
      "layout": {"r": {"x": 1, "bends": [[1, 2], [[3]]]}, "a": {"y": 2}, "c": {}},
      "meta": {"title": "t", "notes": {"r": "why", "a": "how"}}})")
                                .value();
  EXPECT_EQ(format_document(document), R"({
  "rcm": 1,
  "services": {
    "a": "y",
    "b": "x"
  },
  "root": {
    "state": "R",
    "meta": {"id": "r", "icon": "hand"}
  },
  "layout": {
    "a": {"y": 2},
    "c": {},
    "r": {"x": 1, "bends": [[1, 2], [[3]]]}
  },
  "meta": {
    "notes": {
      "a": "how",
      "r": "why"
    },
    "title": "t"
  }
}
)");
}

TEST(FormatDocument, StaysWithin120Columns) {
  Document document = document_of(R"({"state": "R"})");
  const auto line_with = [&](std::size_t length) {
    document.root.parameters = {Parameter{}};
    document.root.parameters[0].name = "p";
    document.root.parameters[0].doc = std::string(length, 'x');
    const std::string text = format_document(document);
    const auto at = text.find("\"name\": \"p\"");
    const auto start = text.rfind('\n', at) + 1;
    return text.substr(start, text.find('\n', at) - start);
  };
  std::size_t longest = 0;
  for (std::size_t length = 0; length < 150; ++length) {
    const std::string line = line_with(length);
    EXPECT_LE(line.size(), 120U);
    if (line.find("doc") != std::string::npos) longest = length;
  }
  EXPECT_GT(longest, 50U);
  EXPECT_LT(longest, 110U);
}

TEST(FormatDocument, CountsCharactersNotBytes) {
  Document ascii = document_of(R"({"state": "R"})"), umlauts = ascii;
  for (int i = 0; i < 70; ++i) {
    ascii.root.doc += "u";
    umlauts.root.doc += "\u00fc";
  }
  const auto lines = [](const std::string& text) { return std::count(text.begin(), text.end(), '\n'); };
  EXPECT_EQ(lines(format_document(ascii)), lines(format_document(umlauts)));
}

TEST(FormatDocument, TakesADraftWhoseLayoutIsNoObject) {
  const Draft draft = read_draft(parse_json(R"({"rcm": 1, "root": {"state": "R"}, "layout": [1]})").value());
  EXPECT_NE(format_document(draft.document).find("\"layout\": [1]"), std::string::npos);
}

/// The largest document without ids, and the deepest; with ids neither can be read again.
Document largest() {
  Document document = document_of(R"({"state": "R"})");
  document.root.doc = std::string(JsonLimits{}.bytes - format_document(document).size() - 20, 'x');
  return document;
}
Document deepest() {
  Document document = document_of(R"({"state": "R"})");
  for (std::size_t level = 2; level < JsonLimits{}.depth; ++level)
    document.root.meta.rest = List{document.root.meta.rest};
  return document;
}

TEST(WriteDocumentText, IsTheFormattedText) {
  for (const Document& document : {largest(), deepest()}) {
    EXPECT_EQ(write_document_text(document).value(), format_document(document));
    EXPECT_TRUE(read_document_text(format_document(document)));
  }
}

TEST(WriteDocumentText, RefusesWhatCouldNotBeReadAgain) {
  for (auto [document, code] :
       {std::pair(largest(), ErrorCode::too_large), std::pair(deepest(), ErrorCode::too_deep)}) {
    give_ids(document);
    EXPECT_EQ(write_document_text(document).error().code, code);
    EXPECT_EQ(read_document_text(format_document(document)).error()[0].code, code);
  }
}

}  // namespace
}  // namespace race::rcm
