// What commands are told of a server that answers, does not, or is none of ours, over real sockets.
#include "server/http/client.h"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <stop_token>
#include <thread>

#include "server/http/encode_part.h"
#include "server/http/listener.h"
#include "server/http/refusal.h"
#include "server/tls/authority.h"
#include "server/wire/calendar.h"
#include "tests/unit/server/bench.h"

namespace race::server {
namespace {

using namespace std::chrono_literals;

std::string url_of(std::uint16_t port) { return "http://127.0.0.1:" + std::to_string(port); }

// Our own server, which answers with what it was asked; at its second place over TLS, by an authority of its own, as in
// a local network.
struct ClientTest : testing::Test {
  ClientTest() {
    const std::int64_t now = now_ms() / 1000;
    const Authority authority = Authority::open(folder.file("tls"), now).value();
    const auto certificate = authority.certificate_for({"127.0.0.1"}, now).value();
    const HttpServer::Place network{.tls = HttpServer::Place::Tls{{"127.0.0.1"}, certificate.chain, certificate.key}};
    server = HttpServer::listen({HttpServer::Place(), network}, "",
                                {admit_all, handle, [] { return Reply(); }, [](const Identity&) { return Reply(); },
                                 hub, displays, edits, presence, control, records, remotes, clients},
                                HttpServer::Limits())
                 .value();
    thread = std::thread([this] { server->run(); });
  }
  ~ClientTest() override {
    server->stop();
    thread.join();
  }
  static void handle(const Request& request, const Answer& answer) {
    if (request.path == "/api/refused") return answer(refusal(std::vector<Error>{{ErrorCode::conflict, "no", "x"}}));
    Reply reply;
    reply.body = Dict{{"method", request.method}, {"path", request.path}, {"body", request.body}};
    if (request.count("if-match") > 0) reply.body = Dict{{"if-match", request.header("if-match")}};
    answer(std::move(reply));
  }
  HttpClient client() const { return HttpClient::create(url_of(server->port())).value(); }

  const TemporaryFolder folder;
  Pool pool{1};
  Hub hub{pool, 1, [](const std::string&) { return std::nullopt; }};
  display::Screens screens;
  NoEdits edits;
  NoPresence presence;
  NoControls control;
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

TEST_F(ClientTest, SendsMethodPathAndBody) {
  const auto got = client().request("GET", "/api/" + encode_part("a /b"));
  ASSERT_TRUE(got) << to_string(got.error());
  EXPECT_EQ(got->status, 200);
  EXPECT_EQ(*got->body.find("method"), Value("GET"));
  EXPECT_EQ(*got->body.find("path"), Value("/api/a /b"));
  EXPECT_EQ(*got->body.find("body"), Value(""));
  const auto put = client().request("PUT", "/api/c", Dict{{"d", 1}});
  ASSERT_TRUE(put) << to_string(put.error());
  EXPECT_EQ(*put->body.find("method"), Value("PUT"));
  EXPECT_EQ(*put->body.find("body"), Value(R"({"d":1})"));
}

TEST_F(ClientTest, SendsHeaders) {
  const auto put = client().request("PUT", "/api/c", Dict{{"d", 1}}, {{"If-Match", "\"3\""}});
  ASSERT_TRUE(put) << to_string(put.error());
  EXPECT_EQ(*put->body.find("if-match"), Value("\"3\""));
}

TEST_F(ClientTest, GivesARefusalAsAnAnswer) {
  const auto refused = client().request("DELETE", "/api/refused");
  ASSERT_TRUE(refused) << to_string(refused.error());
  EXPECT_EQ(refused->status, 409);
  EXPECT_EQ(*refused->body.find("errors")->as_list().front().find("code"), Value("conflict"));
}

TEST_F(ClientTest, TrustsOverTlsTheAuthorityThatItIsTold) {
  const auto ask = [&](const std::string& host, const std::string& trusted) {
    auto client = HttpClient::create("https://" + host + ":" + std::to_string(server->port(1))).value();
    client.set_authority(trusted);
    const auto answer = client.request("PUT", "/api/c", Dict{{"d", 1}});
    return answer ? answer->body.find("body")->as_string() : to_string(answer.error());
  };
  using testing::HasSubstr;
  const std::string authority = folder.file("tls/ca.pem");
  EXPECT_EQ(ask("127.0.0.1", authority), R"({"d":1})");
  EXPECT_THAT(ask("127.0.0.1", ""), HasSubstr("io: is not trusted")) << "the machine does not know it";
  EXPECT_THAT(ask("localhost", authority), HasSubstr("io: is not trusted")) << "it is for another name";
  for (const char* none : {"none.pem", "tls/ca.key"})
    EXPECT_THAT(ask("127.0.0.1", folder.file(none)), HasSubstr("io: no certificate can be read")) << none;
}

TEST_F(ClientTest, FollowsAChannelUntilItIsEnough) {
  std::vector<Value> messages;
  const auto take = [&messages](const Value& message) {
    messages.push_back(message);
    return false;
  };
  EXPECT_TRUE(client().follow("log", take));
  auto over_tls = HttpClient::create("https://127.0.0.1:" + std::to_string(server->port(1))).value();
  over_tls.set_authority(folder.file("tls/ca.pem"));
  EXPECT_TRUE(over_tls.follow("log", take));
  ASSERT_EQ(messages.size(), 2U);
  for (const Value& message : messages) {
    EXPECT_EQ(*message.find("channel"), Value("log"));
    EXPECT_EQ(*message.find("kind"), Value("error")) << "this hub has no channels";
  }
}

TEST_F(ClientTest, FollowsUntilItIsStopped) {
  std::stop_source source;
  const auto stop = [&source](const Value&) {
    source.request_stop();
    return true;
  };
  EXPECT_TRUE(client().follow("log", stop, {.stop = source.get_token()}));
}

// Accepts one connection, says `text`, and holds it until the test is over.
class StrangeServer {
 public:
  explicit StrangeServer(std::string text) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof(address);
    EXPECT_EQ(::bind(socket_, reinterpret_cast<const sockaddr*>(&address), size), 0);
    EXPECT_EQ(::listen(socket_, 1), 0);
    EXPECT_EQ(::getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size), 0);
    url_ = url_of(ntohs(address.sin_port));
    thread_ = std::thread([this, text = std::move(text)] {
      const int client = ::accept(socket_, nullptr, nullptr);
      char byte = 0;
      // Answers once the request begins, and waits for the client to leave.
      if (::recv(client, &byte, 1, 0) == 1 && ::send(client, text.data(), text.size(), MSG_NOSIGNAL) >= 0)
        while (::recv(client, &byte, 1, 0) > 0) {
        }
      ::close(client);
    });
  }
  ~StrangeServer() {
    thread_.join();
    ::close(socket_);
  }
  StrangeServer(const StrangeServer&) = delete;
  StrangeServer& operator=(const StrangeServer&) = delete;
  const std::string& url() const { return url_; }

 private:
  int socket_;
  std::string url_;
  std::thread thread_;
};

Error error_with(const std::string& text, HttpClient::Timeouts timeouts = {}) {
  const StrangeServer server(text);
  const auto answer = HttpClient::create(server.url(), timeouts)->request("GET", "/api/v1/health");
  EXPECT_FALSE(answer);
  EXPECT_EQ(answer.error().path, server.url());
  return answer.error();
}

TEST(HttpClient, CallsWhatIsNoServerOfOursIo) {
  EXPECT_EQ(error_with("SSH-2.0-OpenSSH\r\n\r\n").code, ErrorCode::io);
  EXPECT_EQ(error_with("HTTP/1.1 200 OK\r\nContent-Length: 6\r\n\r\n<html>").code, ErrorCode::io);
  const std::string size = std::to_string(HttpClient::kBodyBytes + 1);
  EXPECT_EQ(error_with("HTTP/1.1 200 OK\r\nContent-Length: " + size + "\r\n\r\n").code, ErrorCode::io);
}

TEST(HttpClient, GivesAnswersThatAreNoJsonAsTheyAre) {
  const StrangeServer server("HTTP/1.1 200 OK\r\nContent-Length: 6\r\n\r\n<html>");
  const auto answer = HttpClient::create(server.url())->request_text("GET", "/metrics");
  ASSERT_TRUE(answer) << to_string(answer.error());
  EXPECT_EQ(answer->status, 200);
  EXPECT_EQ(answer->body, "<html>");
}

TEST(HttpClient, ReadsAnswersOfManyLevels) {
  const auto levels = [](std::size_t count) {
    const std::string body = std::string(count, '[') + std::string(count, ']');
    return "HTTP/1.1 200 OK\r\nContent-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
  };
  const StrangeServer server(levels(HttpClient::kBodyDepth));
  const auto answer = HttpClient::create(server.url())->request("GET", "/api/v1/health");
  ASSERT_TRUE(answer) << to_string(answer.error());
  EXPECT_TRUE(answer->body.is_list());
  EXPECT_EQ(error_with(levels(HttpClient::kBodyDepth + 1)).code, ErrorCode::io);
}

TEST(HttpClient, GivesUpWhatDoesNotAnswerInTime) {
  EXPECT_EQ(error_with("", {3s, 100ms}).code, ErrorCode::unavailable);
  EXPECT_EQ(error_with("HTTP/1.1 200 OK\r\nContent-Length: 6\r\n\r\n{", {3s, 100ms}).code, ErrorCode::unavailable);
}

TEST(HttpClient, FollowsNothingWhereNobodySpeaksOfIt) {
  const auto code = [](const std::string& answer) {
    const StrangeServer strange(answer);
    const auto followed = HttpClient::create(strange.url()).value().follow("log", [](const Value&) { return true; });
    return followed ? std::string() : std::string(name(followed.error().code));
  };
  EXPECT_EQ(code("HTTP/1.1 401 Unauthorized\r\nContent-Length: 0\r\n\r\n"), "rights");
  EXPECT_EQ(code("HTTP/1.1 403 Forbidden\r\nContent-Length: 0\r\n\r\n"), "rights");
  EXPECT_EQ(code("HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\n\r\n"), "unavailable");
}

TEST(HttpClient, GivesTheAnswerOfWhoOpensNoStream) {
  const StrangeServer strange("HTTP/1.1 401 Unauthorized\r\nContent-Length: 13\r\n\r\n{\"errors\":[]}");
  HttpClient::Answer refusal;
  const auto client = HttpClient::create(strange.url()).value();
  EXPECT_FALSE(client.follow("log", [](const Value&) { return true; }, {.refusal = &refusal}));
  EXPECT_EQ(refusal.status, 401);
  EXPECT_EQ(refusal.body, Value(Dict{{"errors", List()}}));
}

TEST(HttpClient, NamesTheUrlWhereNothingListens) {
  std::string url;
  {
    const StrangeServer gone("");
    url = gone.url();
    EXPECT_FALSE(HttpClient::create(url, {3s, 100ms})->request("GET", "/"));
  }
  const auto answer = HttpClient::create(url)->request("GET", "/");
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.error().code, ErrorCode::unavailable);
  EXPECT_EQ(answer.error().path, url);
}

TEST(HttpClient, IsOfAUrl) { EXPECT_EQ(HttpClient::create("127.0.0.1:80").error().code, ErrorCode::syntax); }

}  // namespace
}  // namespace race::server
