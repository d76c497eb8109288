// A document lists its first violations, and whether there are more: kMaxErrors, in the order of core/SEMANTICS.md
// section 1; what comes after them is not looked for.
#include <gtest/gtest.h>

#include <functional>

#include "core/language/check/checker.h"
#include "core/rcm/constraints.h"
#include "core/rcm/document.h"
#include "core/value/error_list.h"
#include "core/value/json.h"

namespace race::rcm {
namespace {

/// `count` JSON texts, between commas.
std::string repeat(std::size_t count, const std::function<std::string(std::size_t)>& item) {
  std::string out;
  for (std::size_t i = 0; i < count; ++i) out += (i ? "," : "") + item(i);
  return out;
}

/// A list of elements without the field that they need.
std::string wrong_shapes(std::size_t count) {
  return R"("actions": [)" + repeat(count, [](std::size_t) { return R"({"when": "True"})"; }) + "]";
}

/// Ports that lead nowhere.
std::string wrong_ports(std::size_t count) {
  return R"("ports": [)" +
         repeat(
             count,
             [](std::size_t i) { return R"({"name": "p)" + std::to_string(i) + R"(", "when": "True", "to": "no"})"; }) +
         "]";
}

/// States of which the code has an error, each another text.
std::string wrong_states(std::size_t count) {
  return R"("children": [)" +
         repeat(count,
                [](std::size_t i) {
                  return R"({"state": "S)" + std::to_string(i) + R"(", "entry": "f(. # )" + std::to_string(i) + R"("})";
                }) +
         "]";
}

std::vector<Error> errors_of(const std::string& fields) {
  const auto read = read_document_text(R"({"rcm": 1, "root": {"state": "R", )" + fields + "}}");
  return read ? std::vector<Error>{} : read.error();
}

TEST(ErrorBound, IsReachedByErrorsOfEachKind) {
  for (const auto& wrong : {wrong_shapes, wrong_ports, wrong_states}) {
    EXPECT_EQ(errors_of(wrong(kMaxErrors)).size(), kMaxErrors);
    EXPECT_EQ(errors_of(wrong(kMaxErrors + 1)).size(), kMaxErrors + 1);
    EXPECT_EQ(errors_of(wrong(5000)).size(), kMaxErrors + 1);
  }
}

TEST(ErrorBound, LeavesTheFirstErrorsInTheirOrder) {
  const auto all = errors_of(wrong_shapes(50) + "," + wrong_ports(60) + "," + wrong_states(70));
  ASSERT_EQ(all.size(), 180U);
  const auto first = errors_of(wrong_shapes(50) + "," + wrong_ports(60) + "," + wrong_states(7000));
  ASSERT_EQ(first.size(), kMaxErrors + 1);
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(first[i], all[i]);
  EXPECT_EQ(first[49].code, ErrorCode::missing);
  EXPECT_EQ(first[50].path, "R.p0");
  EXPECT_EQ(first[110].path, "R/S0");
  EXPECT_EQ(first[kMaxErrors].path, "R/S90");
}

TEST(ErrorBound, EndsTheCheckOfCode) {
  const auto text = R"({"rcm": 1, "root": {"state": "R", )" + wrong_states(5000) + "}}";
  const Draft draft = read_draft(parse_json(text).value());
  CodeChecks checks;
  EXPECT_EQ(violations(draft.document, checks).size(), kMaxErrors + 1);
  EXPECT_EQ(checks.reads(), kMaxErrors + 1) << "of 5000 texts";
}

// A text may have 65536 bytes, and each error in it counts its lines from the beginning.
TEST(ErrorBound, HoldsForOneText) {
  std::string text = "x = [a0";
  for (int i = 1; i < 5000; ++i) text += ", a" + std::to_string(i);
  text += "]";
  const auto errors = language::check(text, language::CodeKind::function, {});
  ASSERT_EQ(errors.size(), kMaxErrors + 1);
  EXPECT_EQ(errors[0].message, "a0 is not known here");
  EXPECT_EQ(errors[kMaxErrors].message, "a200 is not known here");
}

// While the structure has violations, unknown names are not listed: what stands after many of them is.
TEST(ErrorBound, OfOneTextHidesNoErrorOfAnotherCode) {
  std::string entry = "x = [a";
  for (int i = 0; i < 1000; ++i) entry += ", a";
  entry += "]\\nx.nomethod()";
  const auto errors = errors_of(R"("first": "no", "entry": ")" + entry + R"(")");
  ASSERT_EQ(errors.size(), 2U);
  EXPECT_EQ(errors[0].code, ErrorCode::first);
  EXPECT_EQ(errors[1].code, ErrorCode::forbidden);
}

TEST(ErrorBound, HoldsForLongNames) {
  const std::string name(1'000'000, 'n');
  const auto errors = errors_of(R"("children": [{"state": ")" + name + R"(", )" + wrong_ports(1000) + "}]");
  ASSERT_EQ(errors.size(), kMaxErrors + 1);
  std::size_t bytes = 0;
  for (const Error& error : errors) bytes += error.path.size() + error.message.size();
  EXPECT_LE(bytes, errors.size() * 2 * kMaxErrorBytes);
}

TEST(ErrorBound, KeepsADraftThatHasManyErrors) {
  const auto text = R"({"rcm": 1, "root": {"state": "R", )" + wrong_shapes(1000) + R"(, "doc": "kept"}})";
  const Draft draft = read_draft(parse_json(text).value());
  EXPECT_EQ(draft.errors.size(), kMaxErrors + 1);
  EXPECT_EQ(draft.document.root.doc, "kept");
}

}  // namespace
}  // namespace race::rcm
