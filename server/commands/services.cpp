// race services and race call: the services of a running server with their operations, and a call of one
// (api/openapi.yaml, /api/v1/services).
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/value/fields.h"
#include "core/value/json.h"
#include "server/commands/ask_server.h"
#include "server/commands/call_arguments.h"
#include "server/commands/command.h"
#include "server/http/encode_part.h"

namespace race::server {
namespace {

constexpr const char* kRoute = "/api/v1/services";

// What is wrong in the answer of a server is left out here: a list for people.
struct Reader {
  std::vector<Error> errors;
  Fields of(const Value& json) { return {json, "", "the service", errors}; }
};

// jog(velocity, frame="base"): its parameters with their values.
std::string call_text(Fields& operation, Reader& reader) {
  std::string parameters;
  for (const Value& each : operation.list("parameters")) {
    Fields parameter = reader.of(each);
    parameters += (parameters.empty() ? "" : ", ") + parameter.text("name").value_or("");
    if (const Value* value = parameter.find("value")) parameters += '=' + to_json(*value);
  }
  return operation.text("name").value_or("") + '(' + parameters + ')';
}

std::string operation_line(const Value& json, Reader& reader) {
  Fields operation = reader.of(json);
  std::string line = "  " + call_text(operation, reader);
  for (const char* kind : {"moves", "safe", "reads", "held"})
    if (operation.boolean(kind).value_or(false)) line += std::string(" [") + kind + ']';
  const std::string doc = operation.text("doc").value_or("");
  return in_one_line(doc.empty() ? line : line + "  " + doc.substr(0, doc.find('\n')));
}

std::string service_lines(const Value& json, Reader& reader) {
  Fields service = reader.of(json);
  const Value* state = service.find("state");
  std::string line = service.text("key").value_or("") + " (" + service.text("type").value_or("") + ')';
  if (state && state->is_string()) line += ": " + state->as_string();
  if (!service.boolean("available").value_or(true)) line += ", not available";
  std::string lines = in_one_line(line) + '\n';
  const Value* rsm = service.find("rsm");
  if (!rsm) return lines;
  Fields description = reader.of(*rsm);
  for (const Value& operation : description.list("operations")) lines += operation_line(operation, reader) + '\n';
  return lines;
}

int list(const ServerOptions& server) {
  const auto answer = ask_server(server, "GET", kRoute);
  if (!answer) return answer.error();
  if (server.json) {
    std::printf("%s\n", to_json(*answer, 1).c_str());
    return kExitOk;
  }
  Reader reader;
  for (const Value& service : reader.of(*answer).list("services"))
    std::fputs(service_lines(service, reader).c_str(), stdout);
  return kExitOk;
}

struct CallOptions {
  std::string operation;
  std::optional<std::string> first;
  std::vector<std::string> more;
  ServerOptions server;

  std::vector<std::string> arguments() const {
    std::vector<std::string> all = more;
    if (first) all.insert(all.begin(), *first);
    return all;
  }
};

// An error of the service has at least a code.
int print_error(const CallOptions& options, const Value& error) {
  Reader reader;
  Fields fields = reader.of(error);
  const std::string code = fields.text("code").value_or("error"), message = fields.text("message").value_or("");
  std::fprintf(stderr, "%s: %s: %s\n", options.operation.c_str(), in_one_line(code).c_str(),
               message.empty() ? to_json(error).c_str() : in_one_line(message).c_str());
  return kExitFindings;
}

int call(const CallOptions& options) {
  const ServerOptions& server = options.server;
  const auto operation = read_operation(options.operation);
  if (!operation) return refuse(operation.error(), server.json);
  Dict body{{"operation", operation->operation}};
  if (const auto read = read_call_arguments(options.arguments(), body); !read) return refuse(read.error(), server.json);
  const auto answer =
      ask_server(server, "POST", kRoute + ('/' + encode_part(operation->service)) + "/calls", std::move(body));
  if (!answer) return answer.error();
  if (server.json) std::printf("%s\n", to_json(*answer, 1).c_str());
  if (const Value* error = answer->find("error")) return print_error(options, *error);
  const Value* result = answer->find("result");
  if (result && !server.json) std::printf("%s\n", to_json(*result, 1).c_str());
  return kExitOk;
}

std::function<int()> declare_services(Arguments& arguments) {
  const auto server = std::make_shared<ServerOptions>();
  server->declare(arguments, "prints the services as JSON (api/schemas/services.json)");
  return [server] { return list(*server); };
}

std::function<int()> declare_call(Arguments& arguments) {
  const auto options = std::make_shared<CallOptions>();
  arguments.positional("SERVICE.OPERATION", options->operation);
  // By itself: CLI11 would take a list apart that stands among several words.
  arguments.positional("ARGUMENT", options->first,
                       "NAME=VALUE, a value being JSON or else a text; or all in one JSON object or list");
  arguments.positionals("MORE", options->more, false);
  options->server.declare(arguments, "prints the response, {\"result\"} or {\"error\"}, as JSON");
  return [options] { return call(*options); };
}

}  // namespace

const Command kServices = {"services", "lists the services of a running server with their operations",
                           declare_services};
const Command kCall = {"call", "calls an operation of a service of a running server; prints its result", declare_call};

}  // namespace race::server
