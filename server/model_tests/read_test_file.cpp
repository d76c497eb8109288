#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "core/value/fields.h"
#include "core/value/json.h"
#include "server/model_tests/test_file.h"

namespace race::server {
namespace {

constexpr double kAnswerAfter = 0.1, kLimit = 60, kShortestLimit = 0.001;  // s

using Errors = std::vector<Error>;

std::string below(const std::string& path, std::string_view key, std::size_t number) {
  return path + "/" + std::string(key) + "/" + std::to_string(number);
}

std::string required_text(Fields& fields, std::string_view key) {
  auto text = fields.text(key, kRequired);
  if (text && text->empty()) fields.violation(ErrorCode::name, std::string(key) + " is empty", key);
  return text.value_or("");
}

std::optional<double> read_number(Fields& fields, std::string_view key, double least) {
  const auto number = fields.number(key);
  if (number && *number >= least && *number <= kMaxTestSeconds) return number;
  if (number) fields.violation(ErrorCode::out_of_range, std::string(key) + " is too small or more than 86400", key);
  return {};
}

Dict read_dict(Fields& fields, std::string_view key) {
  const auto value = fields.constant(key);
  if (value && value->is_dict()) return value->as_dict();
  if (value) fields.violation(ErrorCode::type, std::string(key) + " is not an object", key);
  return {};
}

MockAnswer read_answer(const Value& json, const std::string& path, Errors& errors) {
  Fields fields(json, path, "answer", errors, kByField);
  MockAnswer answer;
  answer.operation = required_text(fields, "operation");
  const auto result = fields.constant("result"), error = fields.constant("error");
  const auto never = fields.boolean("never");
  answer.never = never.value_or(false);
  if (never && !*never) fields.violation(ErrorCode::constant, "`never` is true, or not there", "never");
  answer.repeat = fields.boolean("repeat").value_or(false);
  answer.after = read_number(fields, "after", 0).value_or(kAnswerAfter);
  const int given = (result ? 1 : 0) + (error ? 1 : 0) + (answer.never ? 1 : 0);
  if (fields.is_object() && given == 0)
    fields.violation(ErrorCode::missing, "an answer has a `result`, an `error`, or `never`");
  if (given > 1) fields.violation(ErrorCode::conflict, "an answer has one of `result`, `error` and `never`");
  if (error) {
    const Value* code = error->find("code");
    if (!code || !code->is_string())
      fields.violation(ErrorCode::type, "an error has a `code`, which is a text", "error");
  }
  answer.is_error = error.has_value();
  if (result || error) answer.data = error ? *error : *result;
  fields.close();
  return answer;
}

MockEvent read_event(const Value& json, const std::string& path, Errors& errors) {
  Fields fields(json, path, "event", errors, kByField);
  MockEvent event;
  event.event = required_text(fields, "event");
  event.at = read_number(fields, "at", 0).value_or(0);
  if (auto data = fields.constant("data")) event.data = std::move(*data);
  fields.close();
  return event;
}

MockScript read_mock(const Value& json, const std::string& path, Errors& errors) {
  Fields fields(json, path, "service", errors, kByField);
  MockScript mock;
  mock.rsm = fields.text("rsm");
  std::size_t number = 0;
  for (const Value& item : fields.list("answers"))
    mock.answers.push_back(read_answer(item, below(path, "answers", number++), errors));
  number = 0;
  for (const Value& item : fields.list("events"))
    mock.events.push_back(read_event(item, below(path, "events", number++), errors));
  std::ranges::stable_sort(mock.events, {}, &MockEvent::at);
  mock.samples = read_dict(fields, "samples");
  fields.close();
  return mock;
}

ExpectedCall read_call(const Value& json, const std::string& path, Errors& errors) {
  Fields fields(json, path, "call", errors, kByField);
  ExpectedCall call;
  call.service = required_text(fields, "service");
  call.operation = required_text(fields, "operation");
  if (const auto args = fields.constant("args")) {
    if (args->is_list())
      call.args = args->as_list();
    else
      fields.violation(ErrorCode::type, "args is not a list", "args");
  }
  call.kwargs = read_dict(fields, "kwargs");
  fields.close();
  return call;
}

std::vector<ExpectedCall> read_calls(Fields& fields, std::string_view key, Errors& errors) {
  std::vector<ExpectedCall> calls;
  for (const Value& item : fields.list(key))
    calls.push_back(read_call(item, below(fields.path(), key, calls.size()), errors));
  return calls;
}

void read_end(Fields& fields, Expectation& expect) {
  expect.outcome = fields.text("outcome");
  expect.status = fields.text("status");
  if (expect.outcome && expect.status)
    fields.violation(ErrorCode::conflict, "a run with an outcome has the status `ended`: one of both", "status");
  static const std::set<std::string> known = {"ended", "faulted", "running"};
  if (expect.status && !known.contains(*expect.status))
    fields.violation(ErrorCode::constant, "status is `ended`, `faulted` or `running`", "status");
}

bool expects_nothing(const Expectation& expect) {
  return !expect.outcome && !expect.status && !expect.within && expect.order.empty() && expect.fired.empty() &&
         expect.not_fired.empty() && expect.calls.empty() && expect.not_called.empty() && expect.results.empty();
}

Expectation read_expectation(const Value& json, const std::string& path, Errors& errors) {
  const std::size_t before = errors.size();
  Fields fields(json, path, "expect", errors, kByField);
  Expectation expect;
  read_end(fields, expect);
  expect.order = fields.texts("order");
  expect.fired = fields.texts("fired");
  expect.not_fired = fields.texts("not_fired");
  expect.calls = read_calls(fields, "calls", errors);
  expect.not_called = read_calls(fields, "not_called", errors);
  expect.results = read_dict(fields, "results");
  expect.within = read_number(fields, "within", 0);
  expect.tolerance = read_number(fields, "tolerance", 0).value_or(0);
  fields.close();
  if (errors.size() == before && expects_nothing(expect))
    fields.violation(ErrorCode::missing, "nothing is expected, so the test cannot fail");
  return expect;
}

ModelTest read_test(const Value& json, const std::string& path, Errors& errors) {
  Fields fields(json, path, "test", errors, kByField);
  ModelTest test;
  test.name = required_text(fields, "name");
  test.doc = fields.text("doc").value_or("");
  test.state = fields.text("state");
  test.arguments = read_dict(fields, "arguments");
  test.cell = fields.boolean("cell").value_or(false);
  constexpr std::int64_t kMaxSeed = std::int64_t{1} << 53U;  // every integer up to it is a double
  if (const auto seed = fields.integer("seed", 0, kMaxSeed)) test.seed = static_cast<std::uint64_t>(*seed);
  test.limit = read_number(fields, "limit", kShortestLimit).value_or(kLimit);
  for (const auto& [key, mock] : read_dict(fields, "services"))
    test.services[key.as_string()] = read_mock(mock, path + "/services/" + key.as_string(), errors);
  if (const Value* expect = fields.find("expect", kRequired))
    test.expect = read_expectation(*expect, path + "/expect", errors);
  fields.close();
  return test;
}

}  // namespace

Checked<TestFile> read_test_file(const Value& json) {
  Errors errors;
  Fields fields(json, "", "test file", errors, kByField);
  TestFile file;
  const Value* version = fields.find("race_test");
  if (fields.is_object() && (!version || !version->is_integer() || version->as_integer() != 1))
    fields.violation(ErrorCode::version, "`race_test` is 1: the version of the format", "race_test");
  std::ignore = fields.text("doc");
  file.model = fields.text("model");
  const List& tests = fields.list("tests", kRequired);
  if (tests.size() > kMaxTests) {
    fields.violation(ErrorCode::too_large, "more than " + std::to_string(kMaxTests) + " tests", "tests");
    return tl::unexpected(std::move(errors));
  }
  if (const Value* given = json.find("tests"); given && given->is_list() && tests.empty())
    fields.violation(ErrorCode::missing, "there is no test", "tests");
  std::set<std::string> names;
  for (const Value& item : tests) {
    const std::string path = "tests/" + std::to_string(file.tests.size());
    file.tests.push_back(read_test(item, path, errors));
    const std::string& name = file.tests.back().name;
    if (!name.empty() && !names.insert(name).second)
      errors.push_back({ErrorCode::duplicate, "another test is called " + quote(name), path + "/name"});
  }
  fields.close();
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return file;
}

Checked<TestFile> read_test_text(std::string_view text) {
  const auto json = parse_json(text, JsonLimits{.bytes = kMaxTestFile});
  if (!json) return tl::unexpected(Errors{json.error()});
  return read_test_file(*json);
}

}  // namespace race::server
