#include "api/cpp/client/api_error.h"

#include <utility>

namespace race::client {
namespace {

bool is_text(const Value* value) { return value && value->is_string(); }

// Whether it has what every error has.
bool is_error(const Value& error) {
  return is_text(error.find("path")) && is_text(error.find("code")) && is_text(error.find("message"));
}

ApiError error_of(int status, List errors) {
  ApiError error;
  const Value& first = errors.front();
  error.status = status;
  error.code = first.find("code")->as_string();
  error.path = first.find("path")->as_string();
  error.message = first.find("message")->as_string();
  error.errors = std::move(errors);
  return error;
}

ApiError own_error(int status, std::string_view code, std::string message) {
  return error_of(status, {Dict{{"path", ""}, {"code", code}, {"message", std::move(message)}}});
}

}  // namespace

tl::unexpected<ApiError> failure(std::string_view code, std::string message, bool may_be_done) {
  ApiError error = own_error(0, code, std::move(message));
  error.may_be_done = may_be_done;
  return tl::unexpected(std::move(error));
}

ApiError connection_error(const Error& error) {
  const std::string_view code = error.code == ErrorCode::unavailable ? kConnection : kProtocol;
  ApiError failed = own_error(0, code, error.path + ": " + error.message);
  failed.may_be_done = true;
  return failed;
}

ApiError refusal(int status, const Value& problem) {
  const Value* const errors = problem.find("errors");
  bool is_problem = errors && errors->is_list() && !errors->as_list().empty();
  if (is_problem)
    for (const Value& each : errors->as_list()) is_problem = is_problem && is_error(each);
  if (!is_problem)
    return own_error(status, kProtocol,
                     "status " + std::to_string(status) + " without problem details: not a server of RACE?");
  ApiError error = error_of(status, errors->as_list());
  const Value* const more = problem.find("more_errors");
  error.more_errors = more && *more == Value(true);
  return error;
}

std::string to_string(const ApiError& error) {
  std::string lines;
  for (const Value& each : error.errors) {
    if (!lines.empty()) lines += '\n';
    const std::string& path = each.find("path")->as_string();
    if (!path.empty()) lines += path + ": ";
    lines += each.find("code")->as_string() + ": " + each.find("message")->as_string();
  }
  return error.more_errors ? lines + "\n..." : lines;
}

}  // namespace race::client
