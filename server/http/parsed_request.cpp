#include "server/http/parsed_request.h"

#include <boost/beast/http/error.hpp>
#include <string>

#include "server/http/refusal.h"
#include "server/http/request_filter.h"

namespace race::server {

namespace http = boost::beast::http;

void set_limits(RequestParser& parser) {
  parser.header_limit(RequestFilter::kHeaderBytes);
  parser.body_limit(RequestFilter::kRunFileBytes);  // of most routes it is less: the filter refuses by Content-Length
}

Expected<Request> to_request(const http::request<http::string_body>& from) {
  Request request;
  request.method = std::string(from.method_string());
  for (const auto& field : from) {
    std::string name(field.name_string());
    for (char& c : name) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c);
    request.headers.emplace_back(std::move(name), std::string(field.value()));
  }
  ASSIGN_OR_RETURN(auto target, parse_target(std::string_view(from.target())));
  request.path = std::move(target.first);
  request.query = std::move(target.second);
  return request;
}

std::optional<Reply> read_error(boost::system::error_code error) {
  if (error == http::error::header_limit || error == http::error::buffer_overflow)
    return refusal(431, "too_large", "a header has at most " + std::to_string(RequestFilter::kHeaderBytes) + " bytes");
  if (error == http::error::body_limit)
    return refusal(413, "too_large", "a body has at most " + std::to_string(RequestFilter::kRunFileBytes) + " bytes");
  if (error.category() == make_error_code(http::error::bad_method).category() && error != http::error::end_of_stream &&
      error != http::error::partial_message)
    return refusal(400, "http", error.message());
  return std::nullopt;
}

}  // namespace race::server
