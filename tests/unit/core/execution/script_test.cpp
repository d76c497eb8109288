// Scripts: which calls answer themselves, and which answers count.
#include "core/execution/script.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/rcm/document.h"
#include "core/rcm/translate.h"
#include "core/value/json.h"

namespace race::execution {
namespace {

// Quotes may be written '.
Value json(std::string text) {
  for (char& c : text) c = c == '\'' ? '"' : c;
  return parse_json(text).value();
}

// The outcome of a run of `root`, or its status while it has none.
std::string outcome(const std::string& root, const std::string& script) {
  const auto document = rcm::read_document(json("{'rcm': 1, 'root': " + root + "}")).value();
  const Value derived = derive(document, read_script(json(script)).value()).value();
  const Value* end = derived.find("outcome");
  return (end ? end : derived.find("status"))->as_string();
}

// Calls an operation of `service`, which is an expression, and waits for the answer or an event.
std::string asking(const std::string& service) {
  std::string root = R"({'state': 'R', 'parameters': [{'name': 's', 'value': ''}], 'entry': 'svc[%].f()', 'ports': [
    {'name': 'lost', 'when': 'svc[%].f.error.code == \'unavailable\''}, {'name': 'answered', 'when': 'svc[%].f.result'},
    {'name': 'went', 'when': 'svc.t.go'}]})";
  for (auto at = root.find('%'); at != std::string::npos; at = root.find('%')) root.replace(at, 1, service);
  return root;
}

constexpr const char* kUnknown = R"(\'ghost\')";
constexpr const char* kGo = "'services': {'t': {'operations': [], 'events': [{'name': 'go'}]}}";
const std::string kGoesOn = std::string("'steps': [{}, {'events': [{'service': 't', 'event': 'go'}]}]}");

TEST(Script, AnswersCallsToWhatItDoesNotDescribe) {
  EXPECT_EQ(outcome(asking(kUnknown), "{'steps': [{}, {}]}"), "lost");
  EXPECT_EQ(outcome(asking("par.s"), "{'steps': [{}, {}]}"), "lost") << "a service may have an empty name";
  EXPECT_EQ(outcome(asking(kUnknown), std::string("{") + kGo + ", " + kGoesOn), "lost")
      << "the answer came before the event";
}

TEST(Script, LeavesAllAnswersToItselfIfItIsClosed) {
  EXPECT_EQ(outcome(asking(kUnknown), "{'closed': true, 'steps': [{}, {}]}"), "running");
  EXPECT_EQ(outcome(asking(kUnknown), std::string("{'closed': true, ") + kGo + ", " + kGoesOn), "went");
  for (const char* service : {"ghost", ""})
    EXPECT_EQ(outcome(asking(*service ? kUnknown : "par.s"),
                      "{'closed': true, 'steps': [{}, {'responses': [{'service': '" + std::string(service) +
                          "', 'operation': 'f', 'call': 1, 'result': 0}]}]}"),
              "answered");
}

TEST(Script, DropsAnswersToCallsOfOtherOperations) {
  for (const char* whose : {"'service': 'zzz', 'operation': 'f'", "'service': 'ghost', 'operation': 'g'"})
    for (const char* call : {", 'call': 1", ""})
      EXPECT_EQ(outcome(asking(kUnknown), "{'closed': true, 'steps': [{}, {'responses': [{" + std::string(whose) +
                                              call + ", 'result': 0}]}]}"),
                "running")
          << whose << call;
}

TEST(Script, IsRefusedWithAClosedThatIsNoBool) {
  const auto script = read_script(json("{'closed': 1, 'steps': []}"));
  ASSERT_FALSE(script);
  EXPECT_EQ(script.error()[0].code, ErrorCode::type);
}

}  // namespace
}  // namespace race::execution
