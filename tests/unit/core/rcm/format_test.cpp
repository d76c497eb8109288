// The text of documents as files hold it.
#include <gtest/gtest.h>

#include "core/rcm/document.h"

namespace race::rcm {
namespace {

Document document_of(std::string_view root) {
  return read_document_text(R"({"rcm": 1, "root": )" + std::string(root) + "}").value();
}

TEST(FormatDocument, PutsWhatIsSmallOnOneLine) {
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
        "ports": [{"name": "done", "when": "True", "to": "B"}]
      },
      {"state": "B"}
    ],
    "first": "A"
  }
}
)");
}

TEST(FormatDocument, StaysWithin120Columns) {
  Document document = document_of(R"({"state": "R"})");
  const auto line_with = [&](std::size_t length) {
    document.root.children = {State{}};
    auto& state = std::get<State>(document.root.children[0]);
    state.name = "A";
    state.entry = std::string(length, 'x');
    const std::string text = format_document(document);
    const auto at = text.find("\"state\": \"A\"");
    const auto start = text.rfind('\n', at) + 1;
    return text.substr(start, text.find('\n', at) - start);
  };
  std::size_t longest = 0;
  for (std::size_t length = 0; length < 150; ++length) {
    const std::string line = line_with(length);
    EXPECT_LE(line.size(), 120U);
    if (line.find("entry") != std::string::npos) longest = length;
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

}  // namespace
}  // namespace race::rcm
