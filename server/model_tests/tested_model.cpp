#include "server/model_tests/tested_model.h"

#include <algorithm>
#include <utility>

#include "core/execution/execution.h"
#include "core/rsm/rules.h"
#include "core/rsm/type.h"
#include "server/model_tests/mock.h"

namespace race::server {
namespace {

using Errors = std::vector<Error>;

const rsm::Operation* find_operation(const rsm::Service& service, const std::string& name) {
  const auto found = std::ranges::find(service.operations, name, &rsm::Operation::name);
  return found == service.operations.end() ? nullptr : &*found;
}

std::string item(const std::string& path, const char* list, std::size_t number) {
  return path + "/" + list + "/" + std::to_string(number);
}

// An error of some transition that answers calls of the operation which another one took, or of one that is declared.
bool may_answer(const rsm::Service& service, const rsm::Operation& operation, const std::string& code) {
  if (!operation.error.is_null() || is_error_of_cell(code)) return true;
  return std::ranges::any_of(service.transitions, [&](const rsm::Transition& t) {
    return t.error == code && std::ranges::any_of(rsm::resolve(service, t), [&](const rsm::Transition* resolved) {
             return resolved->id != t.id && resolved->operation == operation.name;
           });
  });
}

void check_answer(const MockAnswer& answer, const rsm::Service& model, const std::string& path, Errors& errors) {
  const rsm::Operation* operation = find_operation(model, answer.operation);
  if (!operation)
    return errors.push_back(
        {ErrorCode::not_found, "the service has no operation " + quote(answer.operation), path + "/operation"});
  if (answer.never) return;
  const std::string code = answer.is_error ? answer.data.find("code")->as_string() : "";
  if (answer.is_error && !may_answer(model, *operation, code))
    errors.push_back({ErrorCode::constant, quote(answer.operation) + " never answers with the error " + quote(code),
                      path + "/error"});
  if (answer.is_error && (is_error_of_cell(code) || operation->error.is_null())) return;
  if (const auto why = rsm::mismatch(answer.is_error ? operation->error : operation->result, answer.data))
    errors.push_back({ErrorCode::type, *why, path + (answer.is_error ? "/error" : "/result")});
}

void check_event(const std::string& name, const Value& data, const rsm::Service& model, const std::string& path,
                 Errors& errors) {
  const auto event = std::ranges::find(model.events, name, &rsm::Event::name);
  if (event == model.events.end())
    return errors.push_back({ErrorCode::not_found, "the service has no event " + quote(name), path});
  if (const auto why = rsm::mismatch(event->data, data)) errors.push_back({ErrorCode::type, *why, path});
}

void check_ports(const std::vector<std::string>& ports, const semantics::Program& program, const std::string& path,
                 const char* list, Errors& errors) {
  for (std::size_t i = 0; i < ports.size(); ++i)
    if (!program.find_port(ports[i]))
      errors.push_back({ErrorCode::not_found, "there is no port " + quote(ports[i]), item(path, list, i)});
}

void check_calls(const std::vector<ExpectedCall>& calls, const Interfaces& services, const std::string& path,
                 const char* list, Errors& errors) {
  for (std::size_t i = 0; i < calls.size(); ++i) {
    const auto service = services.find(calls[i].service);
    if (service == services.end())
      errors.push_back(
          {ErrorCode::not_found, "there is no service " + quote(calls[i].service), item(path, list, i) + "/service"});
    else if (!find_operation(service->second, calls[i].operation))
      errors.push_back({ErrorCode::not_found, "the service has no operation " + quote(calls[i].operation),
                        item(path, list, i) + "/operation"});
  }
}

void check_arguments_of(const ModelTest& test, const semantics::Program& program, const std::string& path,
                        Errors& errors) {
  append_below(errors, semantics::check_arguments(program, test.arguments), path);
  for (const semantics::ParameterInfo& parameter : program[semantics::Program::root].parameters)
    if (!parameter.value && !parameter.from && !test.arguments.find(parameter.name))
      errors.push_back({ErrorCode::missing, "the root needs this argument", path + "/arguments/" + parameter.name});
}

}  // namespace

Expected<rcm::Document> with_root(const rcm::Document& document, const std::string& state) {
  const auto found = std::ranges::find(document.library, state, &rcm::State::name);
  if (found == document.library.end())
    return unexpected(ErrorCode::not_found, "the library has no state " + quote(state));
  rcm::Document out = document;
  out.root = *found;
  for (rcm::Parameter& parameter : out.root.parameters) parameter.from.reset();  // there is no parent
  return out;
}

void check_mock(const MockScript& script, const rsm::Service& model, const std::string& path, Errors& errors) {
  if (model.is_interface())
    errors.push_back({ErrorCode::missing, "the service has no states, which say what it may answer", path + "/rsm"});
  for (std::size_t i = 0; i < script.answers.size(); ++i)
    check_answer(script.answers[i], model, item(path, "answers", i), errors);
  for (std::size_t i = 0; i < script.events.size(); ++i)
    check_event(script.events[i].event, script.events[i].data, model, item(path, "events", i), errors);
  for (const auto& [event, data] : script.samples)
    check_event(event.as_string(), data, model, path + "/samples/" + event.as_string(), errors);
}

void check_test(const ModelTest& test, const semantics::Program& program, const Interfaces& services,
                const std::string& path, Errors& errors) {
  check_arguments_of(test, program, path, errors);
  const std::string at = path + "/expect";
  const semantics::StateInfo& root = program[semantics::Program::root];
  if (test.expect.outcome && !program.find_port(root.path + "." + *test.expect.outcome))
    errors.push_back({ErrorCode::not_found, "the root has no port " + quote(*test.expect.outcome), at + "/outcome"});
  check_ports(test.expect.order, program, at, "order", errors);
  check_ports(test.expect.fired, program, at, "fired", errors);
  check_ports(test.expect.not_fired, program, at, "not_fired", errors);
  check_calls(test.expect.calls, services, at, "calls", errors);
  check_calls(test.expect.not_called, services, at, "not_called", errors);
  for (const auto& [name, value] : test.expect.results)
    if (std::ranges::find(root.results, name.as_string()) == root.results.end())
      errors.push_back({ErrorCode::not_found, "the root has no result " + quote(name.as_string()),
                        at + "/results/" + name.as_string()});
}

}  // namespace race::server
