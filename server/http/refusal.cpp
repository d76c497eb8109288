#include "server/http/refusal.h"

#include "server/wire/errors.h"

namespace race::server {

int status_of(const std::vector<Error>& errors) {
  switch (errors.front().code) {
    case ErrorCode::rights:
      return 403;
    case ErrorCode::not_found:
      return 404;
    case ErrorCode::conflict:
    case ErrorCode::stopped:
    case ErrorCode::leased:
      return 409;
    case ErrorCode::too_large:
      return 413;
    case ErrorCode::unavailable:
    case ErrorCode::io:
      return 503;
    case ErrorCode::json:
    case ErrorCode::too_deep:
    case ErrorCode::out_of_range:
      return 400;
    case ErrorCode::storage:
      return 507;
    case ErrorCode::corrupt:
      return 500;
    default:
      return 422;
  }
}

Reply refusal(const std::vector<Error>& errors) { return refusal(status_of(errors), errors); }

Reply refusal(int status, const std::vector<Error>& errors) {
  Reply reply;
  reply.status = status;
  reply.body = errors_json(errors);
  return reply;
}

Reply refusal(int status, const std::string& code, const std::string& message) {
  Reply reply;
  reply.status = status;
  reply.body = Dict{{"errors", List{Value(Dict{{"path", ""}, {"code", code}, {"message", message}})}}};
  return reply;
}

}  // namespace race::server
