// How long a connection may take, and how many there may be, over real sockets.
#include "server/http/listener.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <new>
#include <stdexcept>
#include <thread>

#include "server/http/refusal.h"
#include "services/failures.h"
#include "tests/unit/server/bench.h"

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
  int get(const std::string& path) {
    if (!send("GET " + path + " HTTP/1.1\r\n" + host_ + "\r\n")) return 0;
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
    constexpr std::string_view kLength = "Content-Length: ";
    const auto length = answer.find(kLength);
    return length != std::string::npos &&
           answer.size() >= answer.find("\r\n\r\n") + 4 + std::stoul(answer.substr(length + kLength.size()));
  }

  int socket_;
  bool connected_ = false;
  std::string host_;
};

struct ListenerTest : testing::Test {
  ~ListenerTest() override {
    if (server) server->stop();
    if (thread.joinable()) thread.join();
  }
  void serve(const HttpServer::Limits& limits) {
    server = HttpServer::listen(0, "", {answer, hub, displays, edits, remotes}, limits).value();
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
    return request.path == "/api/v1/health" ? Reply() : refusal(404, "not_found", "there is no such route");
  }

  Pool pool{1};
  Hub hub{pool, 1, [](const std::string&) { return std::nullopt; }};
  display::Screens screens;
  NoEdits edits;
  Displays displays{screens, hub};
  services::WorldClock clock;
  NoObserver observer;
  services::Host host{clock, observer};
  remote::Remotes remotes{host, clock, 1s};
  std::unique_ptr<HttpServer> server;
  std::thread thread;
};

TEST_F(ListenerTest, ClosesWhatDoesNotArriveWhileOthersAreServed) {
  serve({300ms, 60s});
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
  EXPECT_GE(std::chrono::steady_clock::now() - begin, 300ms);
  EXPECT_EQ(other->get("/api/v1/health"), 200) << "one that has paused between requests for longer";
}

TEST_F(ListenerTest, ClosesAConnectionThatIsIdleForTooLong) {
  serve({60s, 300ms});
  auto idle = connection(), half = connection("GET /api");
  EXPECT_EQ(idle->get("/api/v1/health"), 200);
  EXPECT_TRUE(idle->is_closed());
  EXPECT_TRUE(half->is_open());
}

TEST_F(ListenerTest, ClosesOneConnectionTooManyUntilAnotherHasEnded) {
  serve({60s, 60s, 2});
  auto first = connection(), second = connection();
  EXPECT_EQ(first->get("/api/v1/health"), 200);
  EXPECT_EQ(second->get("/api/v1/health"), 200);
  EXPECT_TRUE(connection()->is_closed());
  first.reset();
  // The server hears of the end on its own time.
  const auto end = std::chrono::steady_clock::now() + 20s;
  int status = 0;
  while (status == 0 && std::chrono::steady_clock::now() < end) status = connection()->get("/api/v1/health");
  EXPECT_EQ(status, 200);
  EXPECT_EQ(second->get("/api/v1/health"), 200);
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

TEST(Limits, AreHalfAMinuteToArriveAndTwoBetweenRequests) {
  EXPECT_EQ(HttpServer::Limits().read_timeout, 30s);
  EXPECT_EQ(HttpServer::Limits().idle_timeout, 120s);
}

}  // namespace
}  // namespace race::server
