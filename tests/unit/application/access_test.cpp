#include "server/application/access.h"

#include <SQLiteCpp/Database.h>
#include <gtest/gtest.h>

#include "server/accounts/accounts.h"
#include "server/accounts/local_key.h"
#include "server/accounts/tickets.h"
#include "server/handlers/routes.h"
#include "tests/unit/temporary_folder.h"

namespace race::server {
namespace {

TEST(Access, WhileTheAuditLogIsBehindNothingChangesButTheCellIsStopped) {
  const TemporaryFolder place;
  const auto accounts = Accounts::open(place.file("accounts.sqlite")).value();
  const LocalKey key = LocalKey::open(place.file("token"), {}).value();
  Tickets tickets;
  const Gate gate(*accounts, key, tickets);
  const auto audit = AuditLog::open(place.file("audit.sqlite"), [](const Error&) {}).value();
  const Access access(gate, *audit, pattern_of, [](const std::string&) {});
  const auto status = [&](const char* method, const char* path) {
    Request request;
    request.method = method;
    request.path = path;
    const auto admitted = access.admit(request);
    return admitted ? 0 : admitted.error().status;
  };
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

}  // namespace
}  // namespace race::server
