#include "server/application/access.h"

#include <SQLiteCpp/Database.h>
#include <gtest/gtest.h>

#include <thread>

#include "server/accounts/accounts.h"
#include "server/accounts/local_key.h"
#include "server/accounts/tickets.h"
#include "server/handlers/routes.h"
#include "tests/unit/temporary_folder.h"

namespace race::server {
namespace {

struct AccessTest : testing::Test {
  int status(const char* method, const char* path) const {
    Request request;
    request.method = method;
    request.path = path;
    const auto admitted = access.admit(request);
    return admitted ? 0 : admitted.error().status;
  }
  // A request of a stranger, answered with this status.
  void answered(const char* path, int status, const char* retry_after = nullptr) {
    Request request;
    request.method = "POST";
    request.path = path;
    Reply reply;
    reply.status = status;
    if (retry_after) reply.headers.emplace_back("Retry-After", retry_after);
    access.audited(request, Answer([](const Reply&) {}))(reply);
  }
  std::size_t rows() {
    while (audit->waiting() > 0) std::this_thread::yield();
    return audit->list(std::nullopt, 10'000)->entries.size();
  }

  const TemporaryFolder place;
  const std::unique_ptr<Accounts> accounts = Accounts::open(place.file("accounts.sqlite")).value();
  const LocalKey key = LocalKey::open(place.file("token"), {}).value();
  Tickets tickets;
  const Gate gate{*accounts, key, tickets};
  const std::unique_ptr<AuditLog> audit = AuditLog::open(place.file("audit.sqlite"), [](const Error&) {}).value();
  Access access{gate, *audit, pattern_of, [](const std::string&) {}};
};

TEST_F(AccessTest, WhileTheAuditLogIsBehindNothingChangesButTheCellIsStopped) {
  EXPECT_EQ(status("POST", "/api/v1/cores"), 0);
  SQLite::Database other(place.file("audit.sqlite"), SQLite::OPEN_READWRITE);
  other.exec("BEGIN IMMEDIATE");  // the disk is slow
  while (audit->has_room()) audit->append({});
  EXPECT_EQ(status("POST", "/api/v1/cores"), 503);
  EXPECT_EQ(status("POST", "/api/v1/stop/reset"), 503);
  EXPECT_EQ(status("GET", "/api/v1/cores"), 0);
  EXPECT_EQ(status("POST", "/api/v1/stop"), 0);
  other.exec("COMMIT");
}

// Otherwise a stranger could push out what others have done.
TEST_F(AccessTest, OfLoginsThatFailThereAreFewRows) {
  for (int i = 0; i < 1000; ++i)
    for (const int status : {400, 413, 422, 429, 500, 503}) answered("/api/v1/login", status);
  EXPECT_EQ(rows(), 0U) << "no password was looked at";
  for (int i = 0; i < 1000; ++i) answered("/api/v1/login", 401);
  EXPECT_EQ(rows(), std::size_t{Access::kLoginRows});
  for (int i = 0; i < 1000; ++i)
    for (const int status : {401, 409, 422, 429}) answered("/api/v1/pair", status);
  EXPECT_EQ(rows(), std::size_t{Access::kLoginRows}) << "nor of codes that are guessed";
  answered("/api/v1/login", 200);
  answered("/api/v1/pair", 200);
  answered("/api/v1/cores", 422);
  EXPECT_EQ(rows(), std::size_t{Access::kLoginRows} + 3) << "and each of what is done";
}

TEST_F(AccessTest, OfWhatIsRefusedThereAreFewRowsAndNoneOfLimits) {
  const char* const call = "/api/v1/services/robot/calls";
  for (int i = 0; i < 1000; ++i) answered(call, 429);
  EXPECT_EQ(rows(), 0U);
  for (int i = 0; i < 1000; ++i) answered(call, 503, "1");
  EXPECT_EQ(rows(), 0U) << "it says when to try again";
  for (int i = 0; i < 1000; ++i)
    for (const int status : {403, 409, 422}) answered(call, status);
  EXPECT_EQ(rows(), std::size_t{Access::kRefusalRows});
  for (int i = 0; i < 1000; ++i) access.refused({}, {ErrorCode::conflict, "it is there already", "robot"});
  EXPECT_EQ(rows(), std::size_t{Access::kRefusalRows}) << "nor of processes";
  answered(call, 200);
  answered(call, 503);
  EXPECT_EQ(rows(), std::size_t{Access::kRefusalRows} + 2) << "and each of what is done, or may be";
}

TEST_F(AccessTest, EachStopThatLatchesIsARowAndOneAMinuteOfTheOthers) {
  Reply latches, again;
  again.is_routine = true;
  for (int i = 0; i < 3; ++i) {
    access.record_stop({}, latches);
    for (int press = 0; press < 1000; ++press) access.record_stop({}, again);
  }
  EXPECT_EQ(rows(), std::size_t{3 + Access::kStopRows});
}

}  // namespace
}  // namespace race::server
