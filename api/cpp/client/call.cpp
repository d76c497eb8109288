#include "api/cpp/client/call.h"

#include "server/http/encode_part.h"

namespace race::client {

std::string segment(std::string_view text) { return server::encode_part(text); }

void add_query_text(Call& call, std::string_view name, std::string_view text) {
  call.target += call.target.find('?') == std::string::npos ? '?' : '&';
  call.target += server::encode_part(name) + '=' + server::encode_part(text);
}

void add_header(Call& call, std::string_view name, const std::optional<std::string>& value) {
  if (value) call.headers.emplace_back(name, *value);
}

}  // namespace race::client
