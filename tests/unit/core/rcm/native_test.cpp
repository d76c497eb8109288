// Native models as JSON: what translation gives is written and read back, and what is no native model is refused.
#include "core/rcm/native.h"

#include <gtest/gtest.h>

#include "core/rcm/document.h"
#include "core/rcm/translate.h"
#include "tests/unit/core/rcm/cases.h"

namespace race::rcm {
namespace {

TEST(NativeModel, OfEveryConformanceCaseIsReadBackAsItWasWritten) {
  for (const auto& folder : cases(false)) {
    SCOPED_TRACE(folder.filename());
    const Document document = read_document_text(read_text(folder / "model.json")).value();
    const NativeModel native = translate(document).value();
    const Value json = write_native(document, native);
    const auto read = read_native(parse_json(to_json(json), {.depth = 1000}).value(), "native");
    ASSERT_TRUE(read) << to_string(read.error().front());
    EXPECT_EQ(read->root, native.root);
    EXPECT_EQ(read->origin, native.origin);
  }
}

std::set<std::string> refused(const std::string& document, const std::string& origin) {
  const auto json = parse_json(R"({"document": )" + document + R"(, "origin": )" + origin + "}");
  const auto read = read_native(json.value(), "native");
  return read ? std::set<std::string>() : pairs(read.error());
}

using Pairs = std::set<std::string>;

const char* const kDocument =
    R"({"rcm": 1, "root": {"state": "P", "children": [{"state": "A", "ports": [{"name": "p", "when": "False"}]}]}})";

TEST(NativeModel, HasAnOriginForEachOfItsNodesAndPortsAndForNothingElse) {
  EXPECT_EQ(refused(kDocument, R"({"P": "Q", "P/A": "library/A", "P/A.p": "library/A.p"})"), Pairs());
  EXPECT_EQ(refused(kDocument, "{}"),
            Pairs({"native/origin/P: missing", "native/origin/P/A: missing", "native/origin/P/A.p: missing"}));
  EXPECT_EQ(refused(kDocument, R"({"P": "P", "P/A": 1, "P/A.p": "P/A.p", "P/B": "P/B"})"),
            Pairs({"native/origin/P/A: type", "native/origin/P/B: unknown_name"}));
}

TEST(NativeModel, HasNeitherLinksNorOraclesNorALibrary) {
  const std::string library = R"("library": [{"state": "L"}])", origin = R"({"P": "P", "P/A": "P/A"})";
  EXPECT_EQ(refused(R"({"rcm": 1, )" + library + R"(, "root": {"state": "P", "children": [{"state": "A"}]}})", origin),
            Pairs({"native/document/library: unknown_field"}));
  EXPECT_EQ(refused(R"({"rcm": 1, "root": {"state": "P", "children": [{"state": "A", "link": "L"}]}})", origin),
            Pairs({"native/document/P/A: link_unknown"}));
  EXPECT_EQ(refused(R"({"rcm": 1, "root": {"state": "P", "children": [{"state": "A"}], "first": "A",)"
                    R"( "oracle": {"kind": "expr", "expr": "'A'"}}})",
                    origin),
            Pairs({"native/document: oracle"}));
}

TEST(NativeModel, ListsTheViolationsOfItsDocument) {
  EXPECT_EQ(refused(R"({"rcm": 2, "root": {"state": "P", "first": "A", "more": 1}})", "{}"),
            Pairs({"native/document: version", "native/document/P: unknown_field", "native/document/P: first"}));
  EXPECT_EQ(refused("1", "1"), Pairs({"native/origin: type"}));
  EXPECT_EQ(refused("1", "{}"), Pairs({"native/document: type"}));
}

}  // namespace
}  // namespace race::rcm
