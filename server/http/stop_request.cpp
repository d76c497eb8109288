#include "server/http/stop_request.h"

#include <algorithm>

#include "server/http/field_list.h"

namespace race::server {
namespace {

std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find("\r\n");
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 2);
  return line;
}

// How often a header stands, and its last value, in lower case.
struct Header {
  int count = 0;
  std::string value;
};

Header find_header(std::string_view lines, std::string_view name) {
  Header found;
  while (!lines.empty()) {
    const std::string_view line = take_line(lines);
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos || lower(line.substr(0, colon)) != name) continue;
    ++found.count;
    found.value = lower(trim(line.substr(colon + 1)));
  }
  return found;
}

bool is_one_of(const std::string& value, const std::vector<std::string>& all) {
  return std::ranges::find(all, value) != all.end();
}

// 200: the line asks for a stop.
int status_of_line(std::string_view line) {
  const std::size_t method_end = line.find(' '), path_end = line.rfind(' ');
  if (method_end == std::string_view::npos || path_end == method_end) return 400;
  const std::string_view version = line.substr(path_end + 1);
  if (version != "HTTP/1.1" && version != "HTTP/1.0") return 400;
  if (line.substr(method_end + 1, path_end - method_end - 1) != "/api/v1/stop") return 404;
  return line.substr(0, method_end) == "POST" ? 200 : 405;
}

std::string_view reason_of(int status) {
  switch (status) {
    case 200:
      return "OK";
    case 403:
      return "Forbidden";
    case 404:
      return "Not Found";
    case 405:
      return "Method Not Allowed";
    case 421:
      return "Misdirected Request";
    default:
      return "Bad Request";
  }
}

}  // namespace

StopAnswer answer_stop(std::string_view header, const StopNames& names) {
  const int status = status_of_line(take_line(header));
  const Header host = find_header(header, "host"), origin = find_header(header, "origin");
  if (status == 400) return {400, {}};
  if (host.count != 1 || !is_one_of(host.value, names.hosts)) return {421, {}};
  if (origin.count > 1 || (origin.count == 1 && !is_one_of(origin.value, names.origins))) return {403, {}};
  return {status, origin.value};
}

std::string stop_response(const StopAnswer& answer) {
  const std::string body = answer.status == 200 ? "{\"stopped\":true}" : "{\"stopped\":false}";
  std::string text = "HTTP/1.1 " + std::to_string(answer.status) + ' ';
  text += reason_of(answer.status);
  text +=
      "\r\nServer: race\r\nContent-Type: application/json\r\nX-Content-Type-Options: nosniff\r\nCache-Control: "
      "no-store";
  if (answer.status == 405) text += "\r\nAllow: POST";
  if (!answer.origin.empty()) text += "\r\nAccess-Control-Allow-Origin: " + answer.origin + "\r\nVary: Origin";
  text += "\r\nConnection: close\r\nContent-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
  return text;
}

}  // namespace race::server
