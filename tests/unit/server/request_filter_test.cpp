#include "server/http/request_filter.h"

#include <gtest/gtest.h>

namespace race::server {
namespace {

struct RequestFilterTest : testing::Test {
  Request request(std::string method, std::vector<std::pair<std::string, std::string>> headers) {
    Request made;
    made.method = std::move(method);
    made.headers = {{"host", "127.0.0.1:8080"}};
    made.headers.insert(made.headers.end(), headers.begin(), headers.end());
    return made;
  }
  // 0: it is accepted.
  int status(const Request& request, bool upgrade = false) {
    const auto refused = filter.refuse(request, upgrade);
    return refused ? refused->status : 0;
  }
  RequestFilter filter{8080};
};

TEST_F(RequestFilterTest, AcceptsAPlainRequest) { EXPECT_EQ(status(request("GET", {})), 0); }

TEST_F(RequestFilterTest, AcceptsItsOwnHostsAlone) {
  for (const char* host : {"localhost:8080", "127.0.0.1:8080", "[::1]:8080", "LocalHost:8080"}) {
    Request asked = request("GET", {});
    asked.headers[0].second = host;
    EXPECT_EQ(status(asked), 0) << host;
  }
  for (const char* host :
       {"localhost", "localhost:8081", "evil.example:8080", "127.0.0.1.evil.example:8080", "[::2]:8080", ":8080", ""}) {
    Request asked = request("GET", {});
    asked.headers[0].second = host;
    EXPECT_EQ(status(asked), 421) << host;
  }
  for (const char* none : {"127.0.0.1:8080.evil.example", "user@127.0.0.1:8080", "127.0.0.1:x", "::1:8080", "[::1:8080",
                           "127.0.0.1:8080/", "local host:8080", "[::1]x:8080"}) {
    Request asked = request("GET", {});
    asked.headers[0].second = none;
    EXPECT_EQ(status(asked), 400) << none;
  }
}

TEST_F(RequestFilterTest, RequiresExactlyOneHost) {
  EXPECT_EQ(status(request("GET", {{"host", "127.0.0.1:8080"}})), 400);
  Request none = request("GET", {});
  none.headers.clear();
  EXPECT_EQ(status(none), 400);
}

TEST_F(RequestFilterTest, RefusesEveryTransferEncoding) {
  EXPECT_EQ(status(request("POST", {{"transfer-encoding", "chunked"}})), 501);
  EXPECT_EQ(status(request("GET", {{"transfer-encoding", ""}})), 501);
}

TEST_F(RequestFilterTest, RefusesWritesAndStreamsOfOtherOrigins) {
  const std::vector<std::pair<std::string, std::string>> foreign = {{"origin", "http://evil.example"}};
  EXPECT_EQ(status(request("GET", foreign)), 0);
  EXPECT_EQ(status(request("GET", foreign), true), 403);
  for (const char* method : {"POST", "PUT", "DELETE", "PATCH", "OPTIONS"})
    EXPECT_EQ(status(request(method, foreign)), 403) << method;
  EXPECT_EQ(status(request("POST", {{"origin", "http://localhost:8080"}})), 0);
  EXPECT_EQ(status(request("POST", {{"origin", "http://localhost:8080"}, {"origin", "http://localhost:8080"}})), 403);
}

TEST_F(RequestFilterTest, LimitsTheLengthAndTypeOfBodies) {
  const auto with = [&](const char* length, const char* type) {
    return status(request("POST", {{"content-length", length}, {"content-type", type}}));
  };
  EXPECT_EQ(with("4194304", "application/json"), 0);
  EXPECT_EQ(with("4194305", "application/json"), 413);
  EXPECT_EQ(with("99999999999999999999", "application/json"), 400);
  EXPECT_EQ(with("-1", "application/json"), 400);
  EXPECT_EQ(with("10", "application/json; charset=utf-8"), 0);
  EXPECT_EQ(with("10", "text/plain"), 415);
  EXPECT_EQ(with("10", "application/jsonx"), 415);
  EXPECT_EQ(with("10", ""), 415);
  EXPECT_EQ(with("0", "text/plain"), 0);
  EXPECT_EQ(status(request("POST", {{"content-length", "0"}, {"content-length", "0"}})), 400);
}

TEST_F(RequestFilterTest, TakesLargerBodiesWhereFilesOfRunsArrive) {
  const auto with = [&](const char* method, const char* path, const char* length) {
    Request sent = request(method, {{"content-length", length}, {"content-type", "application/json"}});
    sent.path = path;
    return status(sent);
  };
  EXPECT_EQ(with("POST", "/api/v1/runs", "16777216"), 0);
  EXPECT_EQ(with("POST", "/api/v1/runs", "16777217"), 413);
  EXPECT_EQ(with("PUT", "/api/v1/runs", "4194305"), 413);
  EXPECT_EQ(with("POST", "/api/v1/runs/1", "4194305"), 413);
}

}  // namespace
}  // namespace race::server
