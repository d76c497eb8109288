#include "server/http/serving.h"

#include <optional>

#include "server/http/answering.h"
#include "server/http/event_session.h"
#include "server/http/handshake.h"
#include "server/http/listening.h"
#include "server/http/on_pool.h"
#include "server/http/parsed_request.h"
#include "server/http/refusal.h"
#include "server/http/response.h"
#include "server/http/sessions.h"
#include "server/wire/path_pattern.h"
#include "services/failures.h"
#include "services/remote/process_link.h"

namespace race::server {
namespace {

using Phase = Connections::Phase;

constexpr std::string_view kStream = "/api/v1/stream";
constexpr std::string_view kControl = "/api/v1/control/hold";
constexpr std::string_view kComponents = "/api/v1/components";
constexpr std::string_view kHealth = "/api/v1/health";
constexpr std::string_view kStop = "/api/v1/stop";

bool is_health(const Request& request) {
  return request.method == "GET" && request.path == kHealth && request.query.empty() && request.body.empty();
}

bool is_cell_stop(const Request& request) { return request.method == "POST" && request.path == kStop; }

// What a reserved connection may ask for.
bool is_urgent(const Request& request) {
  if (request.method == "GET") return request.path == kHealth;
  if (is_cell_stop(request)) return true;
  return request.method == "POST" && match("/api/v1/cores/{id}/stop", request.path);
}

// The reply to a request that has arrived. What is urgent waits for no other request.
awaitable<Answered> get_reply(Request request, Client& client, Context& context) {
  if (is_health(request)) co_return Answered{context.backend.health(), 0};
  if (is_cell_stop(request)) co_return Answered{context.backend.stop(request.identity), 0};
  Pool& pool = is_urgent(request) ? context.urgent : context.handlers;
  co_return co_await reply_to(std::move(request), client.stream, pool, context);
}

// Its response. The text is made on the threads of the handlers, but of what is urgent: it may be large.
awaitable<Response> respond(Answered answered, bool urgent, ResponseOptions options, Context& context) {
  if (urgent) co_return make_response(std::move(answered.reply), options);
  const auto share = context.budget.take(options.head ? 0 : answered.units);  // until its text has one
  if (!share) co_return make_response(overload("clients hold too much that is not taken yet"), ResponseOptions());
  std::function<Response()> work = [reply = std::move(answered.reply), options]() mutable {
    return make_response(std::move(reply), options);
  };
  co_return co_await on_pool(context.handlers, std::move(work));
}

// Sends what may be much. Whether another request may follow.
awaitable<bool> send_answer(Client& client, Response response, Context& context) {
  const auto share = context.budget.take(response.body().size());
  if (!share) response = make_response(overload("clients hold too much that is not taken yet"), ResponseOptions());
  const bool more = co_await send(client.stream, std::move(response), context.limits.write_timeout);
  if (more) co_return true;
  client.place->begin(Phase::idle);
  co_await drain(client.stream);
  co_return false;
}

awaitable<bool> refuse(Client& client, Reply reply, ResponseOptions options, Context& context) {
  Response response = make_response(std::move(reply), options);
  co_return co_await send_answer(client, std::move(response), context);
}

// (A name within a co_await expression is all that g++ 12 can do.)
Reply bad_target(const Error& error) { return refusal(400, std::vector<Error>{error}); }
std::optional<Reply> refuse_upgrade(const Request& request, bool is_upgrade) {
  Reply reply;
  if (request.method != "GET") {
    reply = refusal(405, "method", "this route has GET");
    reply.headers.emplace_back("Allow", "GET");
    return reply;
  }
  if (is_upgrade) return refuse_handshake(request);
  reply = refusal(426, "upgrade", "a WebSocket is served here");
  reply.headers.emplace_back("Upgrade", "websocket");
  return reply;
}

// Reads the header of the next request; its first byte may take `begin`. Nothing: there is none, and a refusal is sent.
awaitable<std::optional<Request>> read_header(Client& client, RequestParser& parser, std::chrono::milliseconds begin,
                                              Context& context) {
  const bool reserved = client.place->is_reserved();
  const auto timeout = reserved ? context.limits.reserved_timeout : context.limits.read_timeout;
  client.place->begin(Phase::idle);
  client.stream.expires_after(reserved ? timeout : begin);
  if (client.buffer.size() == 0) {
    const auto space = client.buffer.prepare(RequestFilter::kHeaderBytes);
    const auto [error, bytes] = co_await client.stream.async_read_some(space, kAsTuple);
    if (error) co_return std::nullopt;
    client.buffer.commit(bytes);
  }
  client.place->begin(Phase::reading);
  if (!reserved) client.stream.expires_after(timeout);
  const auto [error, bytes] = co_await http::async_read_header(client.stream, client.buffer, parser, kAsTuple);
  client.place->begin(Phase::answering);
  if (error) {
    if (auto reply = read_error(error)) co_await refuse(client, std::move(*reply), ResponseOptions(), context);
    co_return std::nullopt;
  }
  auto request = to_request(parser.get());
  if (request) co_return std::move(*request);
  Reply reply = bad_target(request.error());
  co_await refuse(client, std::move(reply), ResponseOptions(), context);
  co_return std::nullopt;
}

// Why a request that the filter lets through is refused from its header all the same; else `share` is what its body
// takes.
std::optional<Reply> refuse_busy(const Client& client, const Request& request, std::uint64_t body,
                                 ByteBudget::Share& share, Context& context) {
  if (client.place->is_reserved() && (!is_urgent(request) || body > ByteBudget::kFreeBytes))
    return overload("there are too many connections; only health and stop are answered");
  auto taken = context.budget.take(static_cast<std::size_t>(body));
  if (!taken) return overload("clients send too much at once");
  share = std::move(*taken);
  return std::nullopt;
}

// Why who sends it may not; else the request knows who that is. The pages are for everybody: one of them logs in.
std::optional<Reply> refuse_unknown(const Client& client, Request& request, Context& context) {
  if (!is_of_interface(request.path)) return std::nullopt;
  request.identity.address = client.address;
  auto identity = context.backend.admit(request);
  if (!identity) return std::move(identity).error();
  request.identity = std::move(*identity);
  return std::nullopt;
}

// What is refused of a request for a WebSocket; nothing: it may begin.
std::optional<Reply> refuse_websocket(Client& client) {
  if (!client.place->begin_websocket()) return overload("there are too many WebSockets");
  client.place->on_end([] {});  // the session's, soon
  return std::nullopt;
}

awaitable<bool> serve_websocket(Client& client, Request header, Upgrade request, Context& context) {
  const bool is_process = header.path == kComponents;
  auto unknown = !is_process ? ByteBudget::Share() : context.budget.take(remote::ProcessLink::kHelloBytes);
  auto refused = unknown ? refuse_websocket(client) : overload("there are too many processes that nobody knows yet");
  if (refused) co_return co_await refuse(client, std::move(*refused), ResponseOptions(), context);
  Backend& backend = context.backend;
  ClientGauges& clients = backend.clients;
  const Gauge::Hold counted(is_process                ? clients.processes
                            : header.path == kControl ? clients.controls
                                                      : clients.streams);
  if (header.path == kControl) {
    const ControlTargets targets{backend.control, backend.records};
    co_await serve_control(std::move(client.stream), std::move(request), std::move(header.identity), targets,
                           *client.place);
  } else if (!is_process) {
    const StreamTargets targets{backend.hub, backend.displays, backend.edits, backend.presence, backend.records};
    co_await serve_stream(std::move(client.stream), std::move(request), std::move(header.identity), targets,
                          *client.place);
  } else {
    const ComponentTargets targets{backend.remotes, backend.hub, context.handlers, backend.records};
    co_await serve_components(std::move(client.stream), std::move(request), std::move(header.identity), targets,
                              *client.place, std::move(*unknown));
  }
  co_return false;
}

// Follows a channel of the stream until one side ends that; it counts as a WebSocket. `version`: of HTTP, as in 11.
awaitable<bool> follow_channel(Client& client, Reply reply, Identity identity, unsigned version, Context& context) {
  auto refused = refuse_websocket(client);
  if (refused) co_return co_await refuse(client, std::move(*refused), ResponseOptions(), context);
  const Gauge::Hold counted(context.backend.clients.events);
  const EventTargets targets{context.backend.hub, context.backend.records, context.limits.write_timeout, version >= 11};
  ChannelEvents events = std::move(*reply.events);
  Response head = make_response(std::move(reply), ResponseOptions());
  co_await serve_events(std::move(client.stream), std::move(head), std::move(events), std::move(identity), targets,
                        *client.place);
  co_return false;
}

// Serves one request of a connection; its first byte may take `begin`. Returns whether another may follow.
awaitable<bool> serve_one(Client& client, Context& context, std::chrono::milliseconds begin) {
  RequestParser parser;
  set_limits(parser);
  auto request = co_await read_header(client, parser, begin, context);
  if (!request) co_return false;
  const bool upgrade = websocket::is_upgrade(parser.get());
  ResponseOptions options{false, request->method == "HEAD", client.endpoint.stop_sources};
  if (options.head) request->method = "GET";
  ByteBudget::Share body;
  auto refused = client.endpoint.filter.refuse(*request, upgrade);
  if (!refused) refused = refuse_unknown(client, *request, context);
  if (!refused) refused = refuse_busy(client, *request, parser.content_length().value_or(0), body, context);
  if (refused) co_return co_await refuse(client, std::move(*refused), options, context);
  const bool reserved = client.place->is_reserved();
  client.stream.expires_after(reserved ? context.limits.reserved_timeout : context.limits.read_timeout);
  const bool makes_way = reserved && !parser.is_done();  // until its body has come
  if (makes_way) client.place->begin(Phase::reading);
  const auto [error, bytes] = co_await http::async_read(client.stream, client.buffer, parser, kAsTuple);
  if (makes_way) client.place->begin(Phase::answering);
  if (error) {
    if (auto reply = read_error(error)) co_await refuse(client, std::move(*reply), ResponseOptions(), context);
    co_return false;
  }
  if (request->path == kStream || request->path == kControl || request->path == kComponents) {
    auto no_websocket = refuse_upgrade(*request, upgrade);
    if (no_websocket) co_return co_await refuse(client, std::move(*no_websocket), ResponseOptions(), context);
    co_return co_await serve_websocket(client, std::move(*request), parser.release(), context);
  }
  options.keep_alive = parser.keep_alive() && !reserved && !context.ending;
  request->body = std::move(parser.get().body());
  client.stream.expires_never();
  const bool urgent = is_urgent(*request);
  Identity identity = request->identity;
  Answered answered = co_await get_reply(std::move(*request), client, context);
  if (answered.reply.events && !options.head) {
    body = {};  // which is gone, while the answer may go on for days
    co_return co_await follow_channel(client, std::move(answered.reply), std::move(identity), parser.get().version(),
                                      context);
  }
  Response response = co_await respond(std::move(answered), urgent, options, context);
  body = {};
  co_return co_await send_answer(client, std::move(response), context);
}

// Who speaks plain HTTP where TLS is spoken has typed an address without a scheme, probably for the first time: the
// page that says how a device comes to trust this server is next. What was asked is not known, nor by which name.
Reply lead_to_tls(NetStream& stream) {
  error_code gone;
  const auto own = stream.socket().local_endpoint(gone);
  const std::string address = text_of(own.address());
  const std::string host = address.find(':') == std::string::npos ? address : '[' + address + ']';
  Reply reply = refusal(307, "tls", "this server is reached over TLS: by https");
  reply.headers.emplace_back("Location", "https://" + host + ':' + std::to_string(own.port()) + "/trust/");
  return reply;
}

// Whether the client speaks as it is spoken to here.
awaitable<bool> greet(Client& client, Context& context) {
  client.stream.expires_after(context.limits.read_timeout);
  const NetStream::Greeting greeting = co_await client.stream.handshake();
  if (greeting == NetStream::Greeting::plain_http) {
    Reply reply = lead_to_tls(client.stream);
    co_await refuse(client, std::move(reply), ResponseOptions(), context);
  }
  co_return greeting == NetStream::Greeting::done;
}

}  // namespace

awaitable<void> serve(std::unique_ptr<Client> client, Context& context) {
  std::optional<Gauge::Hold> counted;
  counted.emplace(context.backend.clients.connections);
  try {
    bool more = co_await greet(*client, context);
    if (more) more = co_await serve_one(*client, context, context.limits.read_timeout);
    while (more && !context.ending) more = co_await serve_one(*client, context, context.limits.idle_timeout);
  } catch (...) {
    services::report_failure("a connection");
  }
  client.reset();
  if (context.closing && context.connections.empty()) context.io.stop();
}

}  // namespace race::server
