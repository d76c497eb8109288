// What of the C++ client needs no server: folding, gaps, a slow reader, errors, and what is not sent.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <limits>

#include "api/cpp/client/calls.h"
#include "api/cpp/client/client.h"
#include "api/cpp/client/core_updates.h"
#include "api/cpp/client/fold.h"
#include "core/value/json.h"

namespace race::client {
namespace {

Value json(std::string_view text) { return parse_json(text).value(); }

const char* const kState = R"({"core": {"status": "running"}, "state": {
  "active": ["Root", "Root/A"], "ports": ["Root/A.go"], "activated": {"Root/B": ["Root/A.go"]},
  "parameters": {"Root": {"last": 1}}, "results": {"Root": {"n": 1, "m": 2}, "Root/A": {"x": 1}}, "variables": {}}})";

Value delta(std::string_view fields) {
  Dict all = json(R"({"core": {"status": "running"}, "active": {}, "ports": {}, "activated": {}, "parameters": {},
                      "results": {}, "variables": {}, "unset": {}, "fired": [], "calls": []})")
                 .as_dict();
  const Value other = json(fields);
  for (const auto& [name, value] : other.as_dict()) all.set(name, value);
  return all;
}

std::string folded(std::string_view fields, std::string_view part) {
  const auto after = fold(json(kState), delta(fields));
  return after ? to_json(*after->find("state")->find(part)) : "none";
}

TEST(Fold, KeepsWhatADeltaDoesNotName) {
  EXPECT_EQ(*fold(json(kState), delta("{}"))->find("state"), *json(kState).find("state"));
}

TEST(Fold, AddsWhatBecomesActiveBehindTheOthersAndRemovesWhatEnds) {
  EXPECT_EQ(folded(R"({"active": {"Root/A": false, "Root/B": true, "Root": true}})", "active"), R"(["Root","Root/B"])");
  EXPECT_EQ(folded(R"({"ports": {"Root/A.go": false}})", "ports"), "[]");
}

TEST(Fold, DropsBarriersAtWhichNothingHasArrived) {
  EXPECT_EQ(folded(R"({"activated": {"Root/B": [], "Root/C": ["x"]}})", "activated"), R"({"Root/C":["x"]})");
}

TEST(Fold, SetsAndUnsetsValues) {
  EXPECT_EQ(
      folded(R"({"results": {"Root": {"n": 5}}, "unset": {"results": {"Root": ["m"], "Root/A": ["x"]}}})", "results"),
      R"({"Root":{"n":5}})");
  EXPECT_EQ(folded(R"({"variables": {"Root": {"v": null}}})", "variables"), R"({"Root":{"v":null}})");
}

TEST(Fold, RefusesWhatIsNone) {
  EXPECT_FALSE(fold(json(kState), json("{}")));
  EXPECT_FALSE(fold(json("{}"), delta("{}")));
  EXPECT_FALSE(fold(json(kState), delta(R"({"active": []})")));
}

Value message(std::string_view kind, int number, const Value& data) {
  return Dict{{"channel", "core/1/state"}, {"kind", kind}, {"sequence", number}, {"data", data}};
}

TEST(CoreUpdates, AreASnapshotAndDeltasUntilTheRunIsOver) {
  CoreUpdates updates("1");
  updates.receive(message("snapshot", 7, json(kState)));
  updates.receive(message("delta", 8, delta(R"({"core": {"status": "ended"}})")));
  EXPECT_TRUE(updates.is_over());
  EXPECT_EQ(updates.pop()->kind, Update::Kind::snapshot);
  const auto last = updates.pop();
  EXPECT_EQ(last->kind, Update::Kind::delta);
  EXPECT_EQ(status_of(last->state), "ended");
  EXPECT_FALSE(updates.pop());
  EXPECT_FALSE(updates.failure());
}

TEST(CoreUpdates, FailIfADeltaIsMissing) {
  CoreUpdates updates("1");
  updates.receive(message("snapshot", 7, json(kState)));
  updates.receive(message("delta", 9, delta("{}")));
  ASSERT_TRUE(updates.failure());
  EXPECT_EQ(updates.failure()->code, "protocol");
  EXPECT_TRUE(updates.has_next()) << "what came before is read first";
}

TEST(CoreUpdates, HearOfOtherChannelsNothing) {
  CoreUpdates updates("1");
  updates.receive(json(R"({"channel": "cores", "kind": "error", "sequence": 1, "data": {}})"));
  updates.receive(json(R"({"channel": "cores", "kind": "snapshot", "sequence": 1, "data": {}})"));
  EXPECT_FALSE(updates.is_over());
}

TEST(CoreUpdates, EndWithTheErrorOfTheServer) {
  CoreUpdates updates("1");
  updates.receive(
      message("error", 1, json(R"({"errors": [{"path": "core/1", "code": "not_found", "message": "no"}]})")));
  ASSERT_TRUE(updates.failure());
  EXPECT_EQ(updates.failure()->status, 0);
  EXPECT_EQ(to_string(*updates.failure()), "core/1: not_found: no");
}

TEST(CoreUpdates, BecomeOneSnapshotIfTooManyWait) {
  CoreUpdates updates("1", 3);
  updates.receive(message("snapshot", 0, json(kState)));
  for (int i = 1; i <= 3; ++i)
    updates.receive(message("delta", i, delta(R"({"results": {"Root": {"n": )" + std::to_string(i) + "}}}")));
  const auto all = updates.pop();
  EXPECT_EQ(all->kind, Update::Kind::snapshot);
  EXPECT_EQ(all->merged, 4U);
  EXPECT_EQ(*all->state.find("state")->find("results")->find("Root")->find("n"), Value(3));
  EXPECT_FALSE(updates.has_next());
}

TEST(ApiError, HasTheFirstErrorAndAllOfThem) {
  const ApiError error = refusal(422, json(R"({"errors": [{"path": "a", "code": "type", "message": "x"},
    {"path": "b", "code": "name", "message": "y", "line": 3}], "more_errors": true})"));
  EXPECT_EQ(error.status, 422);
  EXPECT_EQ(error.code, "type");
  EXPECT_EQ(error.path, "a");
  EXPECT_FALSE(error.may_be_done);
  EXPECT_EQ(error.errors.size(), 2U);
  EXPECT_EQ(to_string(error), "a: type: x\nb: name: y\n...");
}

TEST(ApiError, SaysThatSomethingElseThanAServerOfOursRefuses) {
  for (const char* const other : {"null", "{}", R"({"errors": []})", R"({"errors": [1]})"})
    EXPECT_EQ(refusal(502, json(other)).code, "protocol") << other;
}

TEST(Calls, EncodeWhatIsOfThePathAndOfTheQuery) {
  EXPECT_EQ(calls::get_document("a/../b?c d").target, "/api/v1/documents/a%2F..%2Fb%3Fc%20d");
  const Call put = calls::put_document("x", Dict(), {.draft = true, .author = "A&B", .if_match = "\"3\""});
  EXPECT_EQ(put.target, "/api/v1/documents/x?draft=true&author=A%26B");
  EXPECT_EQ(put.headers, (std::vector<std::pair<std::string, std::string>>{{"If-Match", "\"3\""}}));
}

TEST(Client, IsOfServersThatNobodyOverhears) {
  for (const char* const url : {"http://127.0.0.1:8080", "http://localhost", "https://robot.local:8443"})
    EXPECT_TRUE(Client::create(url)) << url;
  for (const char* const url : {"http://robot.local:8080", "http://127.evil.example", "ftp://127.0.0.1", ""}) {
    const auto client = Client::create(url);
    ASSERT_FALSE(client) << url;
    EXPECT_EQ(client.error().code, "argument") << url;
  }
}

TEST(Client, SendsNothingThatWouldBeAnotherRequest) {
  EXPECT_FALSE(Client::create("http://127.0.0.1:1", {.token = "a\r\nHost: b"}));
  const auto race = Client::create("http://127.0.0.1:1");
  const auto code = [&race](const Call& call) { return race->send(call).error().code; };
  EXPECT_EQ(code(calls::delete_document("x", {.if_match = "1\r\nHost: b"})), "argument");
  EXPECT_EQ(code(calls::put_document("x", std::numeric_limits<double>::infinity())), "argument");
  EXPECT_EQ(code(calls::get_me()), "connection");
}

// Where connections are made, and nobody answers.
struct SilentServer {
  SilentServer() {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof(address);
    EXPECT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&address), size), 0);
    EXPECT_EQ(::listen(socket, 1), 0);
    EXPECT_EQ(::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size), 0);
    url = "http://127.0.0.1:" + std::to_string(ntohs(address.sin_port));
  }
  ~SilentServer() { ::close(socket); }

  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  std::string url;
};

TEST(Following, EndsAtOnceWhenItIsDestroyed) {
  using namespace std::chrono_literals;
  const SilentServer server;
  const auto begin = std::chrono::steady_clock::now();
  const auto race = Client::create(server.url, {.timeout = 60s});
  const auto updates = race->follow("1", 100ms);
  ASSERT_FALSE(updates);
  EXPECT_EQ(updates.error().code, "timeout");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 30s) << "it would wait for an answer";
}

}  // namespace
}  // namespace race::client
