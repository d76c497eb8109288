// The bytes of a connection: parsed and filtered as the listener does it, one request after the other. However they are
// split into reads, the same requests are let through; each has one allowed host, no Transfer-Encoding, and a body of
// as many bytes as it says.
#include <algorithm>
#include <array>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <charconv>
#include <span>
#include <string>
#include <vector>

#include "core/value/json.h"
#include "server/handlers/preconditions.h"
#include "server/handlers/query.h"
#include "server/http/content_coding.h"
#include "server/http/encode_part.h"
#include "server/http/field_list.h"
#include "server/http/parsed_request.h"
#include "server/http/request_filter.h"
#include "server/wire/path_pattern.h"
#include "tests/fuzz/support/expect.h"
#include "tests/fuzz/support/input.h"

namespace race::server {
namespace {

namespace http = boost::beast::http;
using boost::system::error_code;

constexpr std::uint16_t kPort = 8080;
constexpr std::size_t kBuffer = RequestFilter::kHeaderBytes + 64 * 1024;  // of a connection, as the listener has it

// What handlers read of a request that is let through.
void handle(const Request& request) {
  constexpr std::array<std::string_view, 3> kCodings = {"br", "gzip", "identity"};
  (void)choose_coding(request, kCodings);
  (void)if_none_match_lists(request, "\"3\"");
  (void)if_match(request);
  (void)requires_absence(request);
  (void)query_number(request, "from");
  if (const auto parameters = match("/api/v1/cores/{id}/{what}", request.path))
    FUZZ_EXPECT(fill("/api/v1/cores/{id}/{what}", {parameters->at("id"), parameters->at("what")}) == request.path);
  const auto again = parse_target("/" + encode_part(request.path) + "?" + encode_part(request.path));
  FUZZ_EXPECT(again && again->first == "/" + request.path);
  (void)parse_json(request.body);
}

void hold(const RequestFilter& filter, const Request& request) {
  FUZZ_EXPECT(request.count("transfer-encoding") == 0);
  FUZZ_EXPECT(request.count("host") == 1);
  FUZZ_EXPECT(std::ranges::any_of(filter.hosts, [&](const std::string& host) {
    return std::ranges::equal(host, request.header("host"), {}, {},
                              [](char c) { return c >= 'A' && c <= 'Z' ? c + 32 : c; });
  }));
  FUZZ_EXPECT(request.count("content-length") <= 1);
  std::size_t length = 0;
  const std::string_view text = request.header("content-length");
  std::from_chars(text.data(), text.data() + text.size(), length);
  FUZZ_EXPECT(request.body.size() == length);
}

// One connection whose bytes come in parts of so many.
class Connection {
 public:
  Connection(std::string_view bytes, std::size_t part) : bytes_(bytes), part_(part) {
    while (serve_one()) continue;
  }
  /// A line for each request that is let through.
  const std::string& log() const { return log_; }

 private:
  bool receive() {
    const std::string_view part = bytes_.substr(0, std::min(part_, buffer_.max_size() - buffer_.size()));
    bytes_.remove_prefix(part.size());
    buffer_.commit(boost::asio::buffer_copy(buffer_.prepare(part.size()), boost::asio::buffer(part)));
    return !part.empty();
  }

  // As http::async_read_header and http::async_read do it.
  template <typename Done>
  error_code read(RequestParser& parser, Done done) {
    error_code error;
    while (!done()) {
      buffer_.consume(parser.put(buffer_.data(), error));
      if (error && error != http::error::need_more) return error;
      if (error == http::error::need_more && buffer_.size() == buffer_.max_size()) return http::error::buffer_overflow;
      if (done() || receive()) continue;
      parser.put_eof(error);
      return error ? error : http::error::end_of_stream;
    }
    return {};
  }

  // How it is refused depends on the splitting: Beast may wait for the end of a header before it looks at it.
  static bool refuse(const std::optional<Reply>& reply) {
    FUZZ_EXPECT(!reply || reply->status >= 400);
    return false;
  }

  bool serve_one() {
    RequestParser parser;
    set_limits(parser);
    if (buffer_.size() == 0 && !receive()) return false;
    if (const error_code error = read(parser, [&] { return parser.is_header_done(); }))
      return refuse(read_error(error));
    auto request = to_request(parser.get());
    if (!request) return false;
    const bool upgrade = boost::beast::websocket::is_upgrade(parser.get());
    if (const auto refused = filter_.refuse(*request, upgrade)) return refuse(refused);
    parser.eager(true);
    if (const error_code error = read(parser, [&] { return parser.is_done(); })) return refuse(read_error(error));
    request->body = std::move(parser.get().body());
    hold(filter_, *request);
    handle(*request);
    log_ += request->method + " " + request->path + " " + request->body + (upgrade ? " upgrade\n" : "\n");
    return parser.keep_alive() && !upgrade;
  }

  const RequestFilter filter_{kPort};
  std::string_view bytes_;
  const std::size_t part_;
  boost::beast::flat_buffer buffer_{kBuffer};
  std::string log_;
};

}  // namespace
}  // namespace race::server

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = race::fuzz::text_of(data, size);
  const race::server::Connection whole(bytes, 64 * 1024), split(bytes, 1 + size / 3);
  FUZZ_EXPECT(whole.log() == split.log());
  return 0;
}
