#include "server/http/request_filter.h"

#include <algorithm>
#include <charconv>

#include "server/http/field_list.h"
#include "server/http/refusal.h"

namespace race::server {
namespace {

bool changes_something(const Request& request) { return request.method != "GET" && request.method != "HEAD"; }

std::optional<Reply> refuse_body(const Request& request) {
  if (request.count("content-length") > 1) return refusal(400, "content_length", "Content-Length stands twice");
  const std::string_view length = request.header("content-length");
  std::uint64_t bytes = 0;
  if (!length.empty()) {
    const auto [end, error] = std::from_chars(length.data(), length.data() + length.size(), bytes);
    if (error != std::errc() || end != length.data() + length.size())
      return refusal(400, "content_length", "Content-Length is no number");
  }
  if (bytes == 0) return std::nullopt;
  const bool run_file = request.method == "POST" && request.path == "/api/v1/runs";
  const std::uint64_t most = run_file ? RequestFilter::kRunFileBytes : RequestFilter::kBodyBytes;
  if (bytes > most) return refusal(413, "too_large", "a body has at most " + std::to_string(most) + " bytes");
  const std::string type = lower(request.header("content-type"));
  if (type != "application/json" && !type.starts_with("application/json;"))
    return refusal(415, "content_type", "a body is application/json");
  return std::nullopt;
}

// RFC 9112, 3.2: whether it is a name or an address, an IPv6 one in brackets, and perhaps a port.
bool is_host_header(std::string_view text) {
  const auto is_in = [](std::string_view allowed) {
    return [allowed](char c) {
      const bool is_alnum = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
      return is_alnum || allowed.find(c) != std::string_view::npos;
    };
  };
  const bool is_ipv6 = text.starts_with('[');
  const std::size_t end = is_ipv6 ? text.find(']') : text.find(':');
  if (is_ipv6 && end == std::string_view::npos) return false;
  const std::string_view name = is_ipv6 ? text.substr(1, end - 1) : text.substr(0, end);
  std::string_view port = end == std::string_view::npos ? "" : text.substr(is_ipv6 ? end + 1 : end);
  if (!std::ranges::all_of(name, is_in(is_ipv6 ? ":." : "-._~%!$&'()*+,;="))) return false;
  if (port.empty()) return true;  // also nothing at all
  if (port.front() != ':') return false;
  port.remove_prefix(1);
  return std::ranges::all_of(port, [](char c) { return c >= '0' && c <= '9'; });
}

constexpr std::uint16_t kHttpPort = 80, kHttpsPort = 443;  // which browsers leave out

// As a Host header has them.
std::vector<std::string> hosts_of(const std::vector<std::string>& names, std::uint16_t port, std::uint16_t usual) {
  std::vector<std::string> hosts;
  for (const std::string& name : names) {
    const bool is_ipv6 = name.find(':') != std::string::npos;
    const std::string host = is_ipv6 ? '[' + lower(name) + ']' : lower(name);
    hosts.push_back(host + ':' + std::to_string(port));
    if (port == usual) hosts.push_back(host);
  }
  return hosts;
}

std::vector<std::string> origins_of(const std::string& scheme, const std::vector<std::string>& hosts) {
  std::vector<std::string> origins;
  for (const std::string& host : hosts) origins.push_back(scheme + "://" + host);
  return origins;
}

}  // namespace

RequestFilter::RequestFilter(std::uint16_t port)
    : hosts(hosts_of({"localhost", "127.0.0.1", "::1"}, port, kHttpPort)), origins(origins_of("http", hosts)) {}

RequestFilter::RequestFilter(const std::vector<std::string>& names, std::uint16_t port)
    : hosts(hosts_of(names, port, kHttpsPort)), origins(origins_of("https", hosts)) {}

std::optional<Reply> RequestFilter::refuse(const Request& request, bool upgrade) const {
  if (request.count("transfer-encoding") > 0)
    return refusal(501, "transfer_encoding", "Transfer-Encoding is not served; send Content-Length");
  if (request.count("host") != 1) return refusal(400, "host", "exactly one Host header is needed");
  if (!is_host_header(request.header("host"))) return refusal(400, "host", "Host is no name with a port");
  if (std::ranges::find(hosts, lower(request.header("host"))) == hosts.end())
    return refusal(421, "host", "this server does not answer to that name");
  const bool guarded = upgrade || changes_something(request);
  if (guarded && request.count("origin") > 0 &&
      (request.count("origin") > 1 || std::ranges::find(origins, lower(request.header("origin"))) == origins.end()))
    return refusal(403, "origin", "only pages of this server may do that");
  return refuse_body(request);
}

}  // namespace race::server
