#include "server/commands/core_line.h"

#include <cinttypes>
#include <cstdio>
#include <vector>

#include "core/value/fields.h"
#include "server/commands/ask_server.h"
#include "server/http/encode_part.h"

namespace race::server {
namespace {

// How it stands: why it is interrupted, that it is paused, the fault, or the port by which it ended.
std::string end_text(const Value& core) {
  std::vector<Error> errors;
  Fields fields(core, "", "the core", errors);
  if (const Value* interruption = fields.find("interruption"))
    return Fields(*interruption, "", "the interruption", errors).text("message").value_or("");
  if (fields.boolean("paused").value_or(false)) return "paused";
  const Value* fault = fields.find("fault");
  if (!fault) return fields.text("outcome").value_or("");
  Fields of_fault(*fault, "", "the fault", errors);
  return of_fault.text("at").value_or("") + ": " + of_fault.text("kind").value_or("") + ": " +
         of_fault.text("message").value_or("");
}

}  // namespace

std::string core_path(const std::string& id) { return kCores + ('/' + encode_part(id)); }

Expected<std::string> core_line(const Value& core) {
  std::vector<Error> errors;
  Fields fields(core, "", "the core", errors);
  const auto id = fields.text("id", Fields::Need::required), document = fields.text("document", Fields::Need::required),
             status = fields.text("status", Fields::Need::required);
  const Value* step = fields.find("step", Fields::Need::required);
  if (!errors.empty() || !step->is_integer()) return unexpected(ErrorCode::io, "answers what is no core");
  char text[200];
  std::snprintf(text, sizeof(text), "%4.20s  %-20.64s  %-11.20s  %6" PRId64, id->c_str(), document->c_str(),
                status->c_str(), step->as_integer());
  const std::string end = end_text(core);
  return in_one_line(end.empty() ? text : text + ("  " + end));
}

}  // namespace race::server
