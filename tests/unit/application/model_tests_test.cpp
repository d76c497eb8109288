// Tests of models: the file, what mocks answer, what is expected, and the XML.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/rcm/document.h"
#include "core/rsm/document.h"
#include "core/rsm/type.h"
#include "core/value/json.h"
#include "server/model_tests/allowed_answers.h"
#include "server/model_tests/any_value.h"
#include "server/model_tests/expectations.h"
#include "server/model_tests/junit.h"
#include "server/model_tests/mock.h"
#include "server/model_tests/test_file.h"
#include "server/model_tests/test_of_run.h"
#include "server/model_tests/tested_model.h"
#include "tests/unit/core/execution/journals.h"

namespace race::server {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// Quotes may be written '.
Value json(std::string text) {
  std::ranges::replace(text, '\'', '"');
  return parse_json(text).value();
}

// {path: code} of what is wrong in a test file.
std::map<std::string, std::string> wrong(const std::string& text) {
  const auto file = read_test_file(json(text));
  std::map<std::string, std::string> out;
  if (file) return out;
  for (const Error& error : file.error()) out[error.path] = name(error.code);
  return out;
}

// Of a file with one test that has `more`.
std::map<std::string, std::string> wrong_test(const std::string& more) {
  return wrong("{'race_test': 1, 'tests': [{'name': 'a', " + more + "}]}");
}

using Places = std::map<std::string, std::string>;
const std::string kExpects = "'expect': {'outcome': 'done'}";

TEST(TestFile, IsRefusedWithThePlaceOfEachError) {
  EXPECT_EQ(wrong("[]"), (Places{{"", "type"}}));
  EXPECT_EQ(wrong("{'race_test': 2, 'tests': []}"), (Places{{"race_test", "version"}, {"tests", "missing"}}));
  EXPECT_EQ(wrong("{'race_test': 1}"), (Places{{"tests", "missing"}}));
  EXPECT_EQ(wrong_test(kExpects), Places{});
  EXPECT_EQ(wrong_test("'expect': {}"), (Places{{"tests/0/expect", "missing"}}));
  EXPECT_EQ(wrong_test("'expect': {'tolerance': 1, 'order': []}"), (Places{{"tests/0/expect", "missing"}}));
  EXPECT_EQ(wrong_test("'seed': -1, " + kExpects), (Places{{"tests/0/seed", "out_of_range"}}));
  EXPECT_EQ(wrong_test("'limit': 0, " + kExpects), (Places{{"tests/0/limit", "out_of_range"}}));
  EXPECT_EQ(wrong_test("'limit': 86401, " + kExpects), (Places{{"tests/0/limit", "out_of_range"}}));
  EXPECT_EQ(wrong_test("'limit': 86400, " + kExpects), Places{});
  EXPECT_EQ(wrong_test("'arguments': [], " + kExpects), (Places{{"tests/0/arguments", "type"}}));
  EXPECT_EQ(wrong_test("'expect': {'outcome': 'a', 'status': 'ended'}"),
            (Places{{"tests/0/expect/status", "conflict"}}));
  EXPECT_EQ(wrong_test("'expect': {'status': 'happy'}"), (Places{{"tests/0/expect/status", "constant"}}));
  EXPECT_EQ(wrong_test("'expect': {'calls': [{'service': 'a'}]}"),
            (Places{{"tests/0/expect/calls/0/operation", "missing"}}));
}

TEST(TestFile, KnowsWhatAnAnswerIs) {
  const auto answer = [](const std::string& fields) {
    return wrong_test("'services': {'s': {'answers': [{'operation': 'f'" + fields + "}]}}, " + kExpects);
  };
  const std::string at = "tests/0/services/s/answers/0";
  EXPECT_EQ(answer(", 'result': null"), Places{});
  EXPECT_EQ(answer(", 'never': true"), Places{});
  EXPECT_EQ(answer(", 'result': 1, 'never': false"), (Places{{at + "/never", "constant"}}));
  EXPECT_EQ(answer(""), (Places{{at, "missing"}}));
  EXPECT_EQ(answer(", 'result': 1, 'never': true"), (Places{{at, "conflict"}}));
  EXPECT_EQ(answer(", 'error': {}"), (Places{{at + "/error", "type"}}));
  EXPECT_EQ(answer(", 'result': 1, 'after': -1"), (Places{{at + "/after", "out_of_range"}}));
}

TEST(TestFile, HasABoundedNumberOfTestsWithNamesOfTheirOwn) {
  const auto file = [](std::size_t count) {
    std::string tests;
    for (std::size_t i = 0; i < count; ++i)
      tests += std::string(i ? "," : "") + "{'name': 't" + std::to_string(i) + "', " + kExpects + "}";
    return "{'race_test': 1, 'tests': [" + tests + "]}";
  };
  EXPECT_EQ(wrong(file(kMaxTests)), Places{});
  EXPECT_EQ(wrong(file(kMaxTests + 1)), (Places{{"tests", "too_large"}}));
  EXPECT_EQ(wrong("{'race_test': 1, 'tests': [{'name': 'a', " + kExpects + "}, {'name': 'a', " + kExpects + "}]}"),
            (Places{{"tests/1/name", "duplicate"}}));
}

TEST(AnyValue, IsOfItsType) {
  Random random(1);
  for (const char* type : {"'any'", "'null'", "'bool'", "'int'", "'number'", "'string'", "'pose'", "'image'",
                           "{'list': 'int'}", "{'list': 'number', 'size': 7}", "{'enum': [1, 'a']}",
                           "{'optional': 'int'}", "{'record': {'a': 'int', 'b': {'optional': 'pose'}}}"})
    for (int i = 0; i < 20; ++i)
      EXPECT_EQ(rsm::mismatch(json(type), any_value(json(type), random)), std::nullopt) << type;
}

// Moves, and may fail; is stopped; says how it is.
const rsm::Service& arm() {
  static const rsm::Service service = rsm::read_service(json(R"({'rsm': 1, 'name': 'arm',
        'operations': [{'name': 'move', 'result': 'int'}, {'name': 'stop'}, {'name': 'state', 'result': 'int'}],
        'events': [{'name': 'touch', 'data': 'int'}],
        'states': [{'name': 'Idle'}, {'name': 'Moving'}, {'name': 'Braking'}], 'init': 'Idle',
        'transitions': [
          {'id': 'go', 'src': 'Idle', 'dst': 'Moving', 'operation': 'move', 'defer': ['arrive', 'fail']},
          {'id': 'arrive', 'src': 'Moving', 'dst': 'Idle'},
          {'id': 'brake', 'src': 'Moving', 'dst': 'Braking', 'events': ['touch']},
          {'id': 'fail', 'src': 'Braking', 'dst': 'Idle', 'error': 'broken'},
          {'id': 'stop', 'dst': 'Idle', 'operation': 'stop', 'error': 'stopped'},
          {'id': 'state', 'src': 'Idle', 'dst': 'Idle', 'operation': 'state'}]})"),
                                                        "")
                                          .value();
  return service;
}

TEST(AllowedAnswers, AreOverTheShortestWays) {
  rsm::Instance instance = rsm::initial(arm());
  ASSERT_TRUE(rsm::Trans1(arm(), instance, "move", 1));
  EXPECT_THAT(allowed_answers(arm(), instance, 1),
              ElementsAre(AllowedAnswer{{"arrive"}, false, ""}, AllowedAnswer{{"brake", "fail"}, true, "broken"}));
  EXPECT_THAT(allowed_answers(arm(), instance, 2), ElementsAre());
}

// A host on which a mock acts, as texts.
class Said final : public services::ServiceHost {
 public:
  services::Time now() const override { return time; }
  void transition(std::string_view id, services::CallId) override { said.emplace_back(id); }
  void result(services::CallId call, Value value) override { add("result", call, value); }
  void error(services::CallId call, Value value) override { add("error", call, value); }
  void reject(services::CallId call) override { add("reject", call, {}); }
  void event(std::string_view event, Value data) override { said.push_back(std::string(event) + " " + to_json(data)); }
  void log(std::string) override {}

  services::Time time = 0;
  std::vector<std::string> said;

 private:
  void add(const std::string& what, services::CallId call, const Value& value) {
    said.push_back(what + " " + std::to_string(call) + " " + to_json(value));
  }
};

struct ActingMock {
  Said host;
  std::vector<std::string> problems;
  Mock mock;

  explicit ActingMock(const std::string& script, std::uint64_t seed = 1)
      : mock(arm(), read(script), seed, problems, host) {}

  static MockScript read(const std::string& script) {
    const auto file = read_test_file(
        json("{'race_test': 1, 'tests': [{'name': 'a', 'services': {'arm': " + script + "}, " + kExpects + "}]}"));
    return file.value().tests[0].services.at("arm");
  }
  void call(services::CallId id, const std::string& operation) { mock.call({id, operation, {}, {}}); }
  void pass(double seconds) {
    for (const double end = host.time + seconds; host.time < end - 5e-4;) {
      host.time += 0.001;
      mock.step();
    }
  }
};

TEST(Mock, AnswersWhatIsListedWhenItIsDue) {
  ActingMock arm(
      "{'answers': [{'operation': 'move', 'result': 7, 'after': 0.5}, {'operation': 'move', 'error': {'code': "
      "'broken'}}]}");
  arm.call(1, "move");
  arm.pass(0.499);
  EXPECT_THAT(arm.host.said, ElementsAre("go"));
  arm.pass(0.002);
  EXPECT_THAT(arm.host.said, ElementsAre("go", "arrive", "result 1 7"));
  arm.host.said.clear();
  arm.call(2, "move");
  arm.pass(0.2);
  ASSERT_EQ(arm.host.said.size(), 5U);
  EXPECT_THAT(arm.host.said, ElementsAre("go", "brake", HasSubstr("touch "), "fail", R"(error 2 {"code":"broken"})"));
  EXPECT_TRUE(arm.problems.empty());
}

TEST(Mock, RejectsAndStopsAsItsModelSays) {
  ActingMock arm("{'answers': [{'operation': 'move', 'never': true}]}");
  arm.call(1, "move");
  arm.call(2, "state");
  arm.pass(10);
  arm.call(3, "stop");
  EXPECT_THAT(arm.host.said, ElementsAre("go", "reject 2 null", "stop", R"(error 1 {"code":"stopped"})"));
  arm.pass(0.11);
  EXPECT_EQ(arm.host.said.back(), "result 3 null");
}

TEST(Mock, GivesErrorsOfTheCellWithoutTakingTheCall) {
  ActingMock arm("{'answers': [{'operation': 'move', 'error': {'code': 'leased'}}]}");
  arm.call(1, "move");
  arm.pass(0.2);
  EXPECT_THAT(arm.host.said, ElementsAre(R"(error 1 {"code":"leased"})"));
}

TEST(Mock, RepeatsAnAnswerAndHoldsThatOfACallThatIsDoneAtOnce) {
  ActingMock arm("{'answers': [{'operation': 'state', 'result': 4, 'repeat': true, 'after': 0.1}]}");
  for (services::CallId call : {1U, 2U}) {
    arm.call(call, "state");
    EXPECT_EQ(arm.host.said.size(), 2 * call - 1);
    arm.pass(0.11);
    EXPECT_EQ(arm.host.said.back(), "result " + std::to_string(call) + " 4");
  }
}

TEST(Mock, PutsEventsThatItsModelAllows) {
  ActingMock arm(
      "{'events': [{'event': 'touch', 'data': 3, 'at': 0.2}], 'answers': [{'operation': 'move', 'never': true}]}");
  arm.call(1, "move");
  arm.pass(0.3);
  EXPECT_THAT(arm.host.said, ElementsAre("go", "brake", "touch 3"));
  ActingMock idle("{'events': [{'event': 'touch', 'data': 3, 'at': 0.2}]}");
  idle.pass(0.3);
  EXPECT_TRUE(idle.host.said.empty());
  EXPECT_THAT(idle.problems, ElementsAre(HasSubstr("`touch`")));
}

TEST(Mock, TakesAListedEventForThatOfATransition) {
  ActingMock arm(
      "{'answers': [{'operation': 'move', 'error': {'code': 'broken'}}], 'events': [{'event': 'touch', 'data': 3, "
      "'at': 0.105}]}");
  arm.call(1, "move");
  arm.pass(0.3);
  EXPECT_THAT(arm.host.said, ElementsAre("go", "brake", "touch 3", "fail", R"(error 1 {"code":"broken"})"));
  EXPECT_TRUE(arm.problems.empty());
}

TEST(Mock, LeavesAStateThatOnlyPassesWithItsAnswer) {
  const auto service =
      rsm::read_service(json(R"({'rsm': 1, 'name': 'camera', 'operations': [{'name': 'start', 'error': 'any'}],
    'states': [{'name': 'Idle'}, {'name': 'Starting'}, {'name': 'Seeing'}], 'init': 'Idle',
    'transitions': [{'id': 'start', 'dst': 'Starting', 'operation': 'start', 'defer': ['started', 'refused']},
                    {'id': 'started', 'src': 'Starting', 'dst': 'Seeing'},
                    {'id': 'refused', 'src': 'Starting', 'dst': 'Idle'}]})"),
                        "");
  for (const auto& [answer, last] :
       {std::pair("'result': null", "started"), std::pair("'error': {'code': 'dark'}", "refused")}) {
    Said host;
    std::vector<std::string> problems;
    Mock camera(service.value(), ActingMock::read("{'answers': [{'operation': 'start', " + std::string(answer) + "}]}"),
                1, problems, host);
    camera.call({1, "start", {}, {}});
    EXPECT_THAT(host.said, ElementsAre("start"));
    host.time = 0.1;
    camera.step();
    EXPECT_THAT(host.said, ElementsAre("start", last, HasSubstr(" 1 ")));
  }
}

TEST(Mock, GivesNoAnswerThatItsModelDoesNotAllowInItsState) {
  rsm::Service halting = arm();
  for (rsm::Transition& each : halting.transitions)
    if (each.id == "stop") each.error = "halted";
  const MockScript script = ActingMock::read("{'answers': [{'operation': 'move', 'error': {'code': 'halted'}}]}");
  std::vector<Error> errors;
  check_mock(script, halting, "s", errors);
  EXPECT_TRUE(errors.empty());  // it is one after a call of `stop`
  Said host;
  std::vector<std::string> problems;
  Mock mock(halting, script, 1, problems, host);
  mock.call({1, "move", {}, {}});
  for (host.time = 0.1; host.time < 0.2; host.time += 0.001) mock.step();
  EXPECT_THAT(host.said, ElementsAre("go"));
  EXPECT_THAT(problems, ElementsAre(HasSubstr("`move`")));
}

TEST(Mock, ChoosesByItsSeedAmongAllThatItsModelAllows) {
  const auto said = [](std::uint64_t seed) {
    ActingMock arm("{}", seed);
    for (services::CallId call = 1; call <= 3; ++call) {
      arm.call(call, "move");
      arm.pass(0.2);
    }
    return arm.host.said;
  };
  std::set<std::string> seen;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    EXPECT_EQ(said(seed), said(seed));
    for (const std::string& each : said(seed)) seen.insert(each);
  }
  EXPECT_TRUE(seen.contains("arrive"));
  EXPECT_TRUE(seen.contains("fail"));
}

TEST(Mock, SaysWhatIsListedAndNotAllowed) {
  const auto found = [](const std::string& script) {
    std::vector<Error> errors;
    check_mock(ActingMock::read(script), arm(), "s", errors);
    return errors.empty() ? "" : errors[0].path + " " + std::string(name(errors[0].code));
  };
  EXPECT_EQ(found("{'answers': [{'operation': 'move', 'result': 1}]}"), "");
  EXPECT_EQ(found("{'answers': [{'operation': 'move', 'error': {'code': 'broken'}}]}"), "");
  EXPECT_EQ(found("{'answers': [{'operation': 'move', 'error': {'code': 'lost'}}]}"), "s/answers/0/error constant");
  EXPECT_EQ(found("{'answers': [{'operation': 'move', 'result': 'x'}]}"), "s/answers/0/result type");
  EXPECT_EQ(found("{'answers': [{'operation': 'fly', 'result': 1}]}"), "s/answers/0/operation not_found");
  EXPECT_EQ(found("{'events': [{'event': 'touch', 'data': 'x'}]}"), "s/events/0 type");
  EXPECT_EQ(found("{'samples': {'pull': 1}}"), "s/samples/pull not_found");
}

TEST(Expectations, CompareFieldsAndNumbersWithinATolerance) {
  EXPECT_TRUE(matches(json("{'a': [1, 2.0]}"), json("{'a': [1.0, 2], 'b': 3}"), 0));
  EXPECT_TRUE(matches(1.0, 1.05, 0.1));
  EXPECT_FALSE(matches(1.0, 1.05, 0.01));
  EXPECT_FALSE(matches(json("[1]"), json("[1, 2]"), 9));
  EXPECT_FALSE(matches(json("{'a': 1}"), json("{}"), 9));
  EXPECT_FALSE(matches(true, 1, 9));
}

// The paths of what is not as `expect` says.
std::vector<std::string> unmet(const std::string& expect, const Observed& seen) {
  const auto file = read_test_file(json("{'race_test': 1, 'tests': [{'name': 'a', 'expect': " + expect + "}]}"));
  std::vector<std::string> paths;
  for (const Finding& each : unmet_expectations(file.value().tests[0].expect, seen, "t")) paths.push_back(each.path);
  return paths;
}

TEST(Expectations, AreNamedWhereTheyAreNotMet) {
  Observed seen;
  seen.ports = {{0.1, "R/A.x"}, {0.2, "R/B.x"}};
  seen.calls = {{0.1, "arm", "move", {Value(1)}, Dict{{"speed", 0.5}}}};
  seen.status = "ended";
  seen.outcome = "done";
  seen.results = Dict{{"n", 2}};
  seen.time = 3;
  const std::string met =
      R"({'outcome': 'done', 'order': ['R/A.x', 'R/B.x'], 'not_fired': ['R/C.x'], 'within': 3, 'results': {'n': 2},
    'calls': [{'service': 'arm', 'operation': 'move', 'args': [1], 'kwargs': {'speed': 0.5}}]})";
  EXPECT_THAT(unmet(met, seen), ElementsAre());
  EXPECT_THAT(unmet("{'outcome': 'error'}", seen), ElementsAre("t/expect/outcome"));
  EXPECT_THAT(unmet("{'status': 'running'}", seen), ElementsAre("t/expect/status"));
  EXPECT_THAT(unmet("{'within': 2.9}", seen), ElementsAre("t/expect/within"));
  EXPECT_THAT(unmet("{'order': ['R/B.x', 'R/A.x']}", seen), ElementsAre("t/expect/order/1"));
  EXPECT_THAT(unmet("{'fired': ['R/A.x', 'R/C.x'], 'not_fired': ['R/B.x']}", seen),
              ElementsAre("t/expect/fired/1", "t/expect/not_fired/0"));
  EXPECT_THAT(unmet("{'calls': [{'service': 'arm', 'operation': 'move', 'args': [2]}]}", seen),
              ElementsAre("t/expect/calls/0"));
  EXPECT_THAT(unmet("{'not_called': [{'service': 'arm', 'operation': 'move'}]}", seen),
              ElementsAre("t/expect/not_called/0"));
  EXPECT_THAT(unmet("{'results': {'n': 3, 'm': 1}}", seen), ElementsAre("t/expect/results/n", "t/expect/results/m"));
}

TEST(Junit, HasASuiteForEachFileAndEscapesTexts) {
  const std::vector<TestOutcome> outcomes = {{"a", "x<y", 1, 0.5, {}}, {"b", "z", 2, 1, {{"tests/0", "\"&\x01"}}}};
  const std::string xml = junit_xml(outcomes);
  EXPECT_THAT(xml, HasSubstr(R"(<testsuites tests="2" failures="1")"));
  EXPECT_THAT(xml, HasSubstr(R"(<testsuite name="a" tests="1" failures="0")"));
  EXPECT_THAT(xml, HasSubstr("x&lt;y"));
  EXPECT_THAT(xml, HasSubstr("&quot;&amp;?"));
  EXPECT_THAT(xml, HasSubstr("seed 2"));
}

// A run that ends with its last of `ticks`, each of which brings `data`.
RecordedRun ticking(int ticks, const Value& data) {
  const rcm::Document document = rcm::read_document_text(R"({"rcm": 1, "services": {"t": "timer"},
    "root": {"state": "Root", "results": [{"name": "n", "initial": 0}],
             "actions": [{"when": "svc.t.tick is not None", "do": "res.n = res.n + 1"}],
             "ports": [{"name": "done", "when": "res.n >= )" +
                                                         std::to_string(ticks) + R"("}]}})")
                                     .value();
  const rsm::Service timer = rsm::read_service_text(R"({"events": [{"name": "tick"}]})", "timer").value();
  RecordedRun run{execution::journal_of(document, {{"t", timer}}), {}, {{"t", timer}}};
  run.journal.entries.emplace_back(execution::StartEntry{});
  for (int i = 0; i < ticks; ++i) run.journal.entries.emplace_back(execution::EventEntry{"t", "tick", data});
  return run;
}

TEST(TestOfRun, HasTheInputsOfTheRunInLinesOfTheirOwn) {
  const auto text = test_of_run("a", ticking(3, Dict{{"deep", List{List{List{1}}}}}));
  ASSERT_TRUE(text) << to_string(text.error().front());
  EXPECT_THAT(*text, HasSubstr("\n            {\"event\":\"tick\",\"data\":{\"deep\":[[[1]]]},\"at\":"));
  EXPECT_THAT(*text, HasSubstr("\"outcome\": \"done\""));
}

TEST(TestOfRun, IsBoundedByItsData) {
  const Value large = std::string(1'000'000, 'x');
  EXPECT_TRUE(test_of_run("a", ticking(3, large)));
  const auto text = test_of_run("a", ticking(5, large));
  ASSERT_FALSE(text);
  EXPECT_EQ(text.error().front().code, ErrorCode::too_large);
  EXPECT_EQ(text.error().front().message, "the test would have more than 4 MiB") << "before it is written";
}

TEST(TestOfRun, EndsWhenNobodyWaitsForIt) {
  const std::atomic<bool> stop = true;
  const auto text = test_of_run("a", ticking(3, 1), &stop);
  ASSERT_FALSE(text);
  EXPECT_EQ(text.error().front().code, ErrorCode::unavailable);
}

}  // namespace
}  // namespace race::server
