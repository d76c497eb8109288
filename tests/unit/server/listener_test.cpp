// How long a connection may take, and how many there may be, over real sockets.
#include "server/http/listener.h"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/tcp.h>
#include <openssl/pem.h>
#include <openssl/ssl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <new>
#include <set>
#include <stdexcept>
#include <thread>

#include "server/http/refusal.h"
#include "server/tls/authority.h"
#include "services/failures.h"
#include "tests/unit/server/bench.h"
#include "tests/unit/temporary_folder.h"

namespace race::server {
namespace {

using namespace std::chrono_literals;

// A client's connection; gives up after some seconds, which no test needs.
class Connection {
 public:
  explicit Connection(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    const timeval timeout{20, 0};
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &timeout, sizeof(timeout));
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    connected_ = ::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0;
    host_ = "Host: 127.0.0.1:" + std::to_string(port) + "\r\n";
  }
  ~Connection() { ::close(socket_); }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  const std::string& host() const { return host_; }
  bool connected() const { return connected_; }
  bool send(const std::string& text) {
    return ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(text.size());
  }
  // The status of a request that is answered; 0: the connection has ended.
  int get(const std::string& path) { return ask("GET " + path + " HTTP/1.1\r\n" + host_ + "\r\n"); }
  int post(const std::string& path) { return ask("POST " + path + " HTTP/1.1\r\n" + host_ + "\r\n"); }
  int ask(const std::string& request) { return send(request) ? status() : 0; }
  int status() {
    std::string answer;
    while (answer.find("\r\n\r\n") == std::string::npos || !is_whole(answer))
      if (!receive(answer)) return 0;
    return std::stoi(answer.substr(answer.find(' ')));
  }
  // Whether the server closes it, without a word.
  bool is_closed() {
    std::string answer;
    errno = 0;
    return !receive(answer) && answer.empty() && errno != EAGAIN;
  }
  // How many bytes of an answer's body come, of `bytes`, in that many pauses as make up `time`.
  std::size_t take(std::size_t bytes, std::chrono::milliseconds time) {
    constexpr std::size_t kPieces = 32;
    std::string answer;
    for (std::size_t piece = 1; piece <= kPieces; ++piece) {
      while (answer.size() < piece * bytes / kPieces && receive(answer)) continue;
      std::this_thread::sleep_for(time / kPieces);
    }
    while (!is_whole(answer) && receive(answer)) continue;
    return answer.size() - answer.find("\r\n\r\n") - 4;
  }
  // Waits until the server has closed it, whether or not all has been read.
  void await_end() {
    tcp_info info{};
    socklen_t size = sizeof(info);
    do {
      std::this_thread::sleep_for(5ms);
      ASSERT_EQ(::getsockopt(socket_, IPPROTO_TCP, TCP_INFO, &info, &size), 0);
    } while (info.tcpi_state == TCP_ESTABLISHED);
  }
  // Waits until there is something to read.
  void await_byte() {
    char byte = 0;
    EXPECT_EQ(::recv(socket_, &byte, 1, MSG_PEEK), 1);
  }
  std::string read(std::size_t bytes) {
    std::string text;
    while (text.size() < bytes && receive(text)) continue;
    return text;
  }
  // Whether it is still open: nothing to read, not even its end.
  bool is_open() {
    char byte = 0;
    return ::recv(socket_, &byte, 1, MSG_DONTWAIT | MSG_PEEK) < 0 && errno == EAGAIN;
  }

 private:
  bool receive(std::string& into) {
    char bytes[4096];
    const ssize_t got = ::recv(socket_, bytes, sizeof(bytes), 0);
    if (got > 0) into.append(bytes, static_cast<std::size_t>(got));
    return got > 0;
  }
  static bool is_whole(const std::string& answer) {
    if (answer.starts_with("HTTP/1.1 101")) return true;
    constexpr std::string_view kLength = "Content-Length: ";
    const auto length = answer.find(kLength);  // first: behind it, an answer may be long
    if (length == std::string::npos) return answer.find("Transfer-Encoding: chunked") != std::string::npos;
    return answer.size() >= answer.find("\r\n\r\n") + 4 + std::stoul(answer.substr(length + kLength.size(), 12));
  }

  int socket_;
  bool connected_ = false;
  std::string host_;
};

// Every edit is a mistake of ours.
struct FailingEdits final : EditRequests {
  void request_edit(const std::shared_ptr<Subscriber>& sender, const Value&) override {
    client = sender;
    throw std::runtime_error("no");
  }
  std::weak_ptr<Subscriber> client;
};

// A text message of a client, masked with zeros.
std::string frame(const std::string& text) {
  return std::string("\x81") + static_cast<char>(0x80 | text.size()) + std::string(4, '\0') + text;
}

struct ListenerTest : testing::Test {
  ~ListenerTest() override {
    release = true;
    if (server) server->stop();
    if (thread.joinable()) thread.join();
  }
  void serve(const HttpServer::Limits& limits, std::function<Reply(Request)> handle = answer) {
    serve_later(limits, [handle = std::move(handle)](Request request, const Answer& give) {
      give(handle(std::move(request)));
    });
  }
  void serve_later(const HttpServer::Limits& limits, std::function<void(Request, const Answer&)> handle) {
    server = HttpServer::listen(0, "",
                                {admit_all, std::move(handle), [] { return Reply(); },
                                 [this](const Identity&) {
                                   ++stops;
                                   return Reply();
                                 },
                                 hub, displays, edits, presence, control, records, remotes, clients},
                                limits)
                 .value();
    thread = std::thread([this] { server->run(); });
  }
  std::unique_ptr<Connection> connection(const std::string& text = "") {
    auto made = std::make_unique<Connection>(server->port());
    EXPECT_TRUE(made->connected());
    EXPECT_TRUE(made->send(text));
    return made;
  }
  static Reply answer(const Request& request) {
    if (request.path == "/api/v1/memory") throw std::bad_alloc();
    if (request.path == "/api/v1/mistake") throw std::runtime_error("no");
    if (request.path == "/api/v1/large") return text(std::size_t{64} << 20U);
    if (request.path == "/api/v1/small") return text(1000);
    if (request.path == "/api/v1/cores/1/stop") return Reply();
    if (request.path == "/api/v1/events") return events();
    if (request.path == "/api/v1/cores") return Reply();
    return refusal(404, "not_found", "there is no such route");
  }
  std::string upgrade() const {
    return "GET /api/v1/stream HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(server->port()) +
           "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
           "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n";
  }
  static Reply text(std::size_t bytes) {
    Reply reply;
    reply.text = std::string(bytes, 'x');
    reply.type = "text/plain";
    return reply;
  }
  static Reply events() {
    Reply reply;
    reply.type = "text/event-stream";
    reply.events = ChannelEvents{"log", std::nullopt};
    return reply;
  }
  // A snapshot of the log, once the client follows it.
  void publish_first(Connection& client) {
    Value text("x");
    text.freeze();  // the thread of the hub reads it
    while (client.is_open()) {
      hub.publish_snapshot("log", text);
      std::this_thread::sleep_for(1ms);
    }
  }
  // A header of a request with a body of so many bytes.
  std::string header(std::size_t bytes) const {
    return "POST /api/v1/cores HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(server->port()) +
           "\r\nContent-Type: application/json\r\nContent-Length: " + std::to_string(bytes) + "\r\n\r\n";
  }
  // Connections whose requests are being answered, until `release`.
  std::vector<std::unique_ptr<Connection>> busy(int count) {
    std::vector<std::unique_ptr<Connection>> made;
    for (int i = 0; i < count; ++i)
      made.push_back(
          connection("GET /api/v1/wait HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(server->port()) + "\r\n\r\n"));
    while (begun < std::min(count, 4)) std::this_thread::yield();  // by all handlers
    return made;
  }
  // As answer(); /api/v1/wait waits.
  std::function<Reply(Request)> answer_when_released() {
    return [this](const Request& request) {
      if (request.path != "/api/v1/wait") return answer(request);
      ++begun;
      while (!release) std::this_thread::sleep_for(1ms);
      return Reply();
    };
  }

  // Keeps the answers to requests.
  void serve_never() {
    serve_later({60s, 60s}, [this](const Request& request, const Answer& answer) { keep(request, answer); });
  }
  void keep(const Request& request, const Answer& answer) EXCLUDES(mutex) {
    const services::MutexLock lock(mutex);
    later.push_back(answer);
    gone = request.gone;
  }
  std::size_t kept() EXCLUDES(mutex) {
    const services::MutexLock lock(mutex);
    return later.size();
  }
  std::unique_ptr<Connection> waiting_connection() {
    auto made = connection();
    EXPECT_TRUE(made->send("GET /api/v1/later HTTP/1.1\r\n" + made->host() + "\r\n"));
    return made;
  }

  std::atomic<int> begun{0};
  std::atomic<bool> release{false};
  std::atomic<int> stops{0};  // of the cell
  services::Mutex mutex;
  std::vector<Answer> later GUARDED_BY(mutex);  // to requests that are answered later
  SharedStop gone GUARDED_BY(mutex);            // of the last of them
  Pool pool{1};
  Hub hub{pool, 1, [](const std::string&) { return Source(); }};
  display::Screens screens;
  FailingEdits edits;
  NoControls control;
  NoPresence presence;
  NoRecords records;
  Displays displays{screens, hub};
  services::WorldClock clock;
  NoObserver observer;
  services::Host host{clock, observer};
  remote::Remotes remotes{host, clock, 1s};
  ClientGauges clients;
  std::unique_ptr<HttpServer> server;
  std::thread thread;
};

/// Of the server, where a test waits for its end; what a client does in time is done much sooner, on a busy machine,
/// too.
constexpr auto kPatience = 1000ms;

TEST_F(ListenerTest, ClosesWhatDoesNotArriveWhileOthersAreServed) {
  serve({kPatience, 60s});
  auto other = connection();
  EXPECT_EQ(other->get("/api/v1/health"), 200);
  const auto begin = std::chrono::steady_clock::now();
  const std::string post = "POST /api/v1/cores HTTP/1.1\r\n" + other->host();
  std::vector<std::unique_ptr<Connection>> stalled;
  stalled.push_back(connection());
  stalled.push_back(connection("G"));
  stalled.push_back(connection("GET /api/v1/health HTTP/1.1\r\n" + other->host() + "X-Half: "));
  stalled.push_back(connection(post + "Content-Type: application/json\r\nContent-Length: 100\r\n\r\n{"));
  stalled.push_back(connection());
  EXPECT_EQ(stalled.back()->get("/api/v1/health"), 200);
  EXPECT_TRUE(stalled.back()->send(post));  // after a request that was well
  for (const auto& each : stalled) {
    EXPECT_EQ(other->get("/api/v1/health"), 200);
    EXPECT_TRUE(each->is_closed());
  }
  EXPECT_GE(std::chrono::steady_clock::now() - begin, kPatience);
  EXPECT_EQ(other->get("/api/v1/health"), 200) << "one that has paused between requests for longer";
}

TEST_F(ListenerTest, ClosesAConnectionThatIsIdleForTooLong) {
  serve({60s, kPatience});
  auto idle = connection(), half = connection("GET /api");
  EXPECT_EQ(idle->get("/api/v1/health"), 200);
  EXPECT_TRUE(idle->is_closed());
  EXPECT_TRUE(half->is_open());
}

constexpr Connections::Limits kFew = {.all = 3, .of_address = 3, .websockets = 1, .reserved = 1};

TEST_F(ListenerTest, AnIdleConnectionMakesWayForANewOne) {
  serve({.connections = kFew});
  std::vector<std::unique_ptr<Connection>> idle;
  for (int i = 0; i < 3; ++i) EXPECT_EQ(idle.emplace_back(connection())->get("/api/v1/small"), 200);
  EXPECT_EQ(idle[0]->get("/api/v1/small"), 200);
  EXPECT_EQ(connection()->get("/api/v1/small"), 200);
  EXPECT_TRUE(idle[1]->is_closed());
  EXPECT_TRUE(idle[0]->is_open());
  EXPECT_TRUE(idle[2]->is_open());
}

TEST_F(ListenerTest, HealthAndStopAreAnsweredWhenAllConnectionsAreBusy) {
  serve({.connections = kFew}, answer_when_released());
  const auto others = busy(3);
  EXPECT_EQ(connection()->get("/api/v1/small"), 503);
  EXPECT_EQ(connection()->post("/api/v1/cores"), 503);
  auto reserved = connection();
  EXPECT_EQ(reserved->get("/api/v1/health"), 200);
  EXPECT_TRUE(reserved->is_closed()) << "one request";
  EXPECT_EQ(connection()->post("/api/v1/cores/1/stop"), 200);
  release = true;
  for (const auto& each : others) EXPECT_EQ(each->status(), 200);
}

TEST_F(ListenerTest, AReservedConnectionThatSaysNothingMakesWayOrEnds) {
  serve({.reserved_timeout = 300ms, .connections = kFew}, answer_when_released());
  const auto others = busy(3);
  auto first = connection("GET /api"), second = connection("GET /api");
  EXPECT_TRUE(first->is_closed()) << "made way";
  EXPECT_TRUE(second->is_closed()) << "in time";
}

TEST_F(ListenerTest, AReservedConnectionWhoseBodyDoesNotComeMakesWay) {
  serve({.reserved_timeout = 60s, .connections = kFew}, answer_when_released());
  const auto others = busy(3);
  auto first = connection("POST /api/v1/cores/1/stop HTTP/1.1\r\n" + others[0]->host() +
                          "Content-Type: application/json\r\nContent-Length: 2\r\n\r\n{");
  std::this_thread::sleep_for(100ms);  // for the server to read its header
  EXPECT_EQ(connection()->get("/api/v1/health"), 200);
  EXPECT_TRUE(first->is_closed());
}

TEST_F(ListenerTest, AWebSocketTooManyIsRefused) {
  serve({.connections = kFew});
  auto first = connection(), second = connection();
  EXPECT_EQ(first->ask(upgrade()), 101);
  EXPECT_EQ(second->ask(upgrade()), 503);
  first.reset();
  int status = 0;
  while (status != 101) status = connection()->ask(upgrade());  // the server hears of the end on its own time
}

TEST_F(ListenerTest, EventsCountAsAWebSocket) {
  serve({.connections = kFew});
  auto first = connection(), second = connection();
  EXPECT_EQ(first->get("/api/v1/events"), 200);
  EXPECT_EQ(second->get("/api/v1/events"), 503);
  EXPECT_EQ(connection()->ask(upgrade()), 503);
  first.reset();
  int status = 0;
  while (status != 101) status = connection()->ask(upgrade());
}

TEST_F(ListenerTest, EventsHoldNoBytesOfTheirRequest) {
  serve({.held_bytes = 1'000'000});
  const std::string body(600'000, ' ');
  auto client = connection();
  EXPECT_EQ(client->ask("GET /api/v1/events HTTP/1.1\r\n" + client->host() +
                        "Content-Type: application/json\r\nContent-Length: 600000\r\n\r\n" + body),
            200);
  EXPECT_EQ(connection()->ask(header(600'000) + body), 200);
}

TEST_F(ListenerTest, EventsEndWithTheServer) {
  serve({});
  auto client = connection();
  EXPECT_EQ(client->get("/api/v1/events"), 200);
  publish_first(*client);
  const std::string event =
      "id: 1\nevent: snapshot\ndata: "
      R"({"channel":"log","sequence":1,"kind":"snapshot","data":"x"})"
      "\n\n";
  EXPECT_EQ(client->read(event.size() + 6), "59\r\n" + event + "\r\n");
  server->stop();
  EXPECT_EQ(client->read(5), "0\r\n\r\n");
  EXPECT_TRUE(client->is_closed());
}

TEST_F(ListenerTest, WhoTakesNoEventsIsCut) {
  serve({.write_timeout = 200ms});
  auto client = connection();
  EXPECT_EQ(client->get("/api/v1/events"), 200);
  publish_first(*client);
  hub.publish_delta("log", Value(std::string(std::size_t{16} << 20U, 'x')));
  client->await_end();
  EXPECT_EQ(connection()->get("/api/v1/small"), 200);
  while (hub.message_bytes() > 1000) std::this_thread::yield();  // what it has not taken is given back
}

TEST_F(ListenerTest, HealthWaitsForNoHandler) {
  serve({}, answer_when_released());
  const auto waiting = busy(8);
  EXPECT_EQ(connection()->get("/api/v1/health"), 200);
  release = true;
  for (const auto& each : waiting) EXPECT_EQ(each->status(), 200);
}

TEST_F(ListenerTest, BodiesTakeSharesOfABudgetBeforeTheyAreRead) {
  serve({.held_bytes = 1'000'000});
  auto first = connection(header(600'000) + "{"), second = connection();
  EXPECT_EQ(connection()->get("/api/v1/health"), 200);  // after the first
  EXPECT_EQ(second->ask(header(600'000)), 503);
  EXPECT_EQ(connection()->ask(header(2) + "{}"), 200) << "small ones pass";
  first.reset();
  int status = 503;
  while (status == 503) status = connection()->ask(header(600'000) + std::string(600'000, ' '));
  EXPECT_EQ(status, 200);
}

TEST_F(ListenerTest, WhoDoesNotTakeItsAnswerIsCutAndOthersAreRefusedUntilThen) {
  serve({.write_timeout = kPatience});
  const std::string request = "GET /api/v1/large HTTP/1.1\r\n" + connection()->host() + "\r\n";
  auto slow = connection(request);
  slow->await_byte();
  EXPECT_EQ(connection()->ask(request), 503);
  EXPECT_EQ(connection()->get("/api/v1/small"), 200) << "small ones pass";
  slow->await_end();
  EXPECT_EQ(connection()->get("/api/v1/large"), 200);
}

// All handlers are at work: it would be one of them that made the text.
TEST_F(ListenerTest, AnAnswerForWhichNoBytesAreLeftIsRefusedBeforeItsTextIsMade) {
  serve_later({.held_bytes = 1'000'000}, [this](const Request& request, const Answer& answer) {
    if (request.path == "/api/v1/later") return keep(request, answer);
    answer(answer_when_released()(request));
  });
  auto refused = waiting_connection();
  while (kept() < 1) std::this_thread::yield();
  auto small = waiting_connection();
  while (kept() < 2) std::this_thread::yield();
  auto body = connection(header(900'000) + "{");
  while (connection()->ask(header(200'000) + std::string(200'000, ' ')) == 200) continue;  // until that has its share
  const auto others = busy(4);
  const services::MutexLock lock(mutex);
  Reply large;
  large.body = std::string(200'000, 'x');
  later[0](large);
  EXPECT_EQ(refused->status(), 503);
  later[1](Reply());
  release = true;
  EXPECT_EQ(small->status(), 200);
}

TEST_F(ListenerTest, WhoTakesItsAnswerSlowlyGetsTheWhole) {
  serve({.write_timeout = kPatience});
  auto slow = connection("GET /api/v1/large HTTP/1.1\r\n" + connection()->host() + "\r\n");
  EXPECT_EQ(slow->take(std::size_t{64} << 20U, 2 * kPatience), std::size_t{64} << 20U);
}

TEST_F(ListenerTest, WebSocketsGetACloseFrameWhenTheServerEnds) {
  serve({});
  auto client = connection(), idle = connection();
  EXPECT_EQ(client->ask(upgrade()), 101);
  EXPECT_EQ(idle->get("/api/v1/small"), 200);
  server->stop();
  EXPECT_EQ(client->read(19), std::string("\x88\x11\x03\xe9the server ends", 19)) << "1001, going away";
  EXPECT_TRUE(idle->is_closed());
}

TEST_F(ListenerTest, AnExceptionEndsAWebSocketAndTheHubHearsOfIt) {
  std::vector<std::string> reported;  // one at a time
  services::set_failure_handler([&](const std::string& text) { reported.push_back(text); });
  serve({});
  auto client = connection();
  EXPECT_EQ(client->ask(upgrade()), 101);
  EXPECT_TRUE(client->send(frame(R"({"type": "subscribe", "channel": "log"})") + frame(R"({"type": "edit"})")));
  EXPECT_TRUE(client->is_closed());
  services::set_failure_handler({});
  EXPECT_EQ(reported, (std::vector<std::string>{"a client of the stream failed: no"}));
  while (!edits.client.expired()) std::this_thread::yield();  // the hub holds it no more
}

TEST_F(ListenerTest, RequestsThatNoHandlerHasBegunAreDroppedWhenTheServerEnds) {
  serve({}, answer_when_released());
  const auto waiting = busy(20);
  EXPECT_EQ(connection()->get("/api/v1/health"), 200);  // after them
  server->stop();
  thread.join();
  std::thread end([this] { server.reset(); });
  std::this_thread::sleep_for(50ms);  // for it to drop them
  release = true;
  end.join();
  EXPECT_EQ(begun, 4);
}

TEST_F(ListenerTest, AnExceptionEndsItsRequestAlone) {
  std::vector<std::string> reported;  // one at a time
  services::set_failure_handler([&](const std::string& text) { reported.push_back(text); });
  serve({60s, 60s});
  auto client = connection();
  EXPECT_EQ(client->get("/api/v1/memory"), 503);
  EXPECT_EQ(client->get("/api/v1/mistake"), 500);
  EXPECT_EQ(client->get("/api/v1/health"), 200);
  services::set_failure_handler({});
  EXPECT_EQ(reported, (std::vector<std::string>{"GET /api/v1/memory failed: no memory is left",
                                                "GET /api/v1/mistake failed: no"}));
}

TEST_F(ListenerTest, AnAnswerThatComesLaterKeepsNoThread) {
  serve_never();
  std::vector<std::unique_ptr<Connection>> waiting;
  for (int i = 0; i < 20; ++i) waiting.push_back(waiting_connection());
  while (kept() < waiting.size()) std::this_thread::yield();
  EXPECT_EQ(connection()->get("/api/v1/health"), 200);
  const services::MutexLock lock(mutex);
  later.front()(refusal(409, "conflict", "no"));
  later.clear();
  std::multiset<int> statuses;
  for (const auto& each : waiting) statuses.insert(each->status());
  EXPECT_EQ(statuses.count(409), 1U);
  EXPECT_EQ(statuses.count(503), waiting.size() - 1) << "what is dropped is answered, too";
}

TEST_F(ListenerTest, AClientThatClosesWhileItWaitsIsGone) {
  serve_never();
  auto client = waiting_connection();
  while (kept() < 1) std::this_thread::yield();
  const services::MutexLock lock(mutex);
  EXPECT_FALSE(*gone);
  client.reset();
  while (!*gone) std::this_thread::yield();
}

TEST_F(ListenerTest, EndsWhileAnswersAreAwaited) {
  serve_never();
  auto client = waiting_connection();
  while (kept() < 1) std::this_thread::yield();
  server->stop();
  thread.join();
  server.reset();
  EXPECT_TRUE(client->is_closed());
  const services::MutexLock lock(mutex);
  later.front()(Reply());  // reaches nobody
}

// The certificates that a client gets which connects there, as PEM.
std::string chain_at(std::uint16_t port) {
  SSL_CTX* context = SSL_CTX_new(TLS_client_method());
  BIO* connection = BIO_new_ssl_connect(context);
  BIO_set_conn_hostname(connection, ("127.0.0.1:" + std::to_string(port)).c_str());
  SSL* tls = nullptr;
  BIO_get_ssl(connection, &tls);
  std::string chain;
  if (BIO_do_connect(connection) == 1 && BIO_do_handshake(connection) == 1) {
    BIO* text = BIO_new(BIO_s_mem());
    STACK_OF(X509)* certificates = SSL_get_peer_cert_chain(tls);
    for (int i = 0; i < sk_X509_num(certificates); ++i) PEM_write_bio_X509(text, sk_X509_value(certificates, i));
    char* data = nullptr;
    const auto size = BIO_get_mem_data(text, &data);
    chain.assign(data, static_cast<std::size_t>(size));
    BIO_free(text);
  }
  BIO_free_all(connection);
  SSL_CTX_free(context);
  return chain;
}

TEST_F(ListenerTest, ANewCertificateIsServedFromThenOn) {
  const TemporaryFolder place;
  const Authority authority = Authority::open(place.file("tls"), 1'800'000'000).value();
  const auto certificate = [&](std::int64_t now) { return authority.certificate_for({"127.0.0.1"}, now).value(); };
  const ServerCertificate first = certificate(1'800'000'000), second = certificate(1'900'000'000);
  ASSERT_NE(first.chain, second.chain);
  server =
      HttpServer::listen(
          std::vector<HttpServer::Place>{{.tls = HttpServer::Place::Tls{{"127.0.0.1"}, first.chain, first.key}}}, "",
          {admit_all, [](const Request& request, const Answer& give) { give(answer(request)); }, [] { return Reply(); },
           [](const Identity&) { return Reply(); }, hub, displays, edits, presence, control, records, remotes, clients},
          HttpServer::Limits())
          .value();
  thread = std::thread([this] { server->run(); });
  for (const std::uint16_t port : {server->port(), server->stop_port()}) EXPECT_EQ(chain_at(port), first.chain);
  EXPECT_EQ(server->set_certificate(0, second.chain, first.key).error().code, ErrorCode::not_accepted);
  for (const std::uint16_t port : {server->port(), server->stop_port()}) EXPECT_EQ(chain_at(port), first.chain);
  ASSERT_TRUE(server->set_certificate(0, second.chain, second.key));
  for (const std::uint16_t port : {server->port(), server->stop_port()}) EXPECT_EQ(chain_at(port), second.chain);
}

TEST(Limits, AreHalfAMinuteToArriveTwoBetweenRequestsAndTenSecondsForAMiB) {
  EXPECT_EQ(HttpServer::Limits().read_timeout, 30s);
  EXPECT_EQ(HttpServer::Limits().idle_timeout, 120s);
  EXPECT_EQ(HttpServer::Limits().write_timeout, 10s);
}

}  // namespace
}  // namespace race::server
