// The documents of tests/conformance: the rejected ones have the expected violations, the others are valid and
// translate.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/rcm/document.h"
#include "core/rcm/translate.h"
#include "core/rsm/document.h"
#include "tests/unit/core/rcm/cases.h"

namespace race::rcm {
namespace {

/// The violations of a model and of the services of its script.
std::vector<Error> violations_of(const std::filesystem::path& folder) {
  std::vector<Error> out;
  if (const auto document = read_document_text(read_text(folder / "model.json")); !document) out = document.error();
  const Value script = parse_json(read_text(folder / "script.json")).value();
  const Value* services = script.find("services");
  for (const auto& [key, service] : services ? services->as_dict() : Dict()) {
    const auto read = rsm::read_service(service, "services/" + key.as_string());
    if (!read) out.insert(out.end(), read.error().begin(), read.error().end());
  }
  return out;
}

/// Those of the document and the services; what does not fit in the steps of the script is another one's
/// (core/execution).
std::set<std::string> expected_pairs(const std::filesystem::path& folder) {
  const Value expected = parse_json(read_text(folder / "expected.json")).value();
  std::set<std::string> out;
  for (const Value& error : expected.find("errors")->as_list())
    if (const std::string& path = error.find("path")->as_string(); !path.starts_with("steps/"))
      out.insert(path + ": " + error.find("code")->as_string());
  return out;
}

bool is_native(const State& state) {
  if (state.link || state.oracle) return false;
  if (std::ranges::any_of(state.ports, [](const Port& port) { return port.after.has_value(); })) return false;
  for (const Node& child : state.children) {
    if (const auto* inner = std::get_if<State>(&child); inner && !is_native(*inner)) return false;
  }
  return true;
}

TEST(Conformance, RejectedDocumentsHaveTheseViolations) {
  ASSERT_GE(cases(true).size(), 12U);
  for (const auto& folder : cases(true)) EXPECT_EQ(pairs(violations_of(folder)), expected_pairs(folder)) << folder;
}

TEST(Conformance, TheOtherDocumentsAreValid) {
  ASSERT_GE(cases(false).size(), 50U);
  for (const auto& folder : cases(false)) EXPECT_EQ(pairs(violations_of(folder)), std::set<std::string>{}) << folder;
}

TEST(Conformance, ValidDocumentsTranslateToNativeModels) {
  for (const auto& folder : cases(false)) {
    const auto model = translate(read_document_text(read_text(folder / "model.json")).value());
    ASSERT_TRUE(model) << folder;
    EXPECT_TRUE(is_native(model->root)) << folder;
  }
}

TEST(Conformance, ValidDocumentsSurviveWritingAndFormatting) {
  for (const auto& folder : cases(false)) {
    const Document document = read_document_text(read_text(folder / "model.json")).value();
    EXPECT_EQ(read_document(write_document(document)).value(), document) << folder;
    const std::string text = format_document(document);
    EXPECT_EQ(read_document_text(text).value(), document) << folder;
    EXPECT_EQ(format_document(read_document_text(text).value()), text) << folder;
  }
}

}  // namespace
}  // namespace race::rcm
