#include "server/http/stop_request.h"

#include <gtest/gtest.h>

namespace race::server {
namespace {

const StopNames kNames{{"localhost:8081", "127.0.0.1:8081"}, {"http://localhost:8080", "http://127.0.0.1:8080"}};

int status(const std::string& header) { return answer_stop(header, kNames).status; }

TEST(StopRequest, StopsForWhoeverAsksByAnOwnName) {
  EXPECT_EQ(status("POST /api/v1/stop HTTP/1.1\r\nHost: localhost:8081\r\n\r\n"), 200);
  EXPECT_EQ(status("POST /api/v1/stop HTTP/1.0\r\nhOST:127.0.0.1:8081 \r\n\r\n"), 200);
  EXPECT_EQ(status("POST /api/v1/stop HTTP/1.1\r\nHost: LOCALHOST:8081\r\nContent-Length: 5\r\n\r\nhello"), 200)
      << "a body is never read";
}

TEST(StopRequest, ForPagesOfThisServerAlone) {
  const std::string own = "POST /api/v1/stop HTTP/1.1\r\nHost: localhost:8081\r\nOrigin: ";
  const StopAnswer page = answer_stop(own + "http://localhost:8080\r\n\r\n", kNames);
  EXPECT_EQ(page.status, 200);
  EXPECT_EQ(page.origin, "http://localhost:8080") << "the page may read the answer";
  for (const char* origin : {"http://evil.example", "null", "", "https://localhost:8080", "http://localhost:8081",
                             "http://localhost:8080.evil.example"})
    EXPECT_EQ(status(own + origin + "\r\n\r\n"), 403) << origin;
  EXPECT_EQ(status(own + "http://localhost:8080\r\nOrigin: http://localhost:8080\r\n\r\n"), 403);
}

TEST(StopRequest, ByAnOwnNameAlone) {
  for (const char* host : {"evil.example:8081", "localhost:8080", "localhost", "", "localhost:8081.evil"})
    EXPECT_EQ(status(std::string("POST /api/v1/stop HTTP/1.1\r\nHost: ") + host + "\r\n\r\n"), 421) << host;
  EXPECT_EQ(status("POST /api/v1/stop HTTP/1.1\r\n\r\n"), 421);
  EXPECT_EQ(status("POST /api/v1/stop HTTP/1.1\r\nHost: localhost:8081\r\nHost: localhost:8081\r\n\r\n"), 421);
}

TEST(StopRequest, IsTheOnlyRequest) {
  const std::string rest = "\r\nHost: localhost:8081\r\n\r\n";
  EXPECT_EQ(status("GET /api/v1/stop HTTP/1.1" + rest), 405);
  EXPECT_EQ(status("post /api/v1/stop HTTP/1.1" + rest), 405);
  for (const char* path : {"/", "/api/v1/stop/", "/api/v1/stop?x", "/api/v1/health", "//api/v1/stop"})
    EXPECT_EQ(status("POST " + std::string(path) + " HTTP/1.1" + rest), 404) << path;
  for (const char* line : {"", " ", "POST", "POST /api/v1/stop", "POST /api/v1/stop HTTP/2", "\r\n", "\x16\x03\x01"})
    EXPECT_EQ(status(line + rest), 400) << line;
}

TEST(StopRequest, AnAnswerEndsTheConnection) {
  EXPECT_EQ(stop_response({200, "http://localhost:8080"}),
            "HTTP/1.1 200 OK\r\nServer: race\r\nContent-Type: application/json\r\nX-Content-Type-Options: nosniff\r\n"
            "Cache-Control: no-store\r\nAccess-Control-Allow-Origin: http://localhost:8080\r\nVary: Origin\r\n"
            "Connection: close\r\nContent-Length: 16\r\n\r\n{\"stopped\":true}");
}

}  // namespace
}  // namespace race::server
