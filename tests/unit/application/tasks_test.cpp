#include "server/handlers/tasks.h"

#include <gmock/gmock.h>

#include "server/http/refusal.h"

namespace race::server {
namespace {

Request request_of(const std::string& account, const std::string& prefer = "") {
  Request request;
  request.method = "POST";
  request.path = "/api/v1/backups";
  request.identity = {account, Role::developer};
  if (!prefer.empty()) request.headers.emplace_back("prefer", prefer);
  return request;
}

std::string id_of(const Expected<Value>& task) { return task.value().find("id")->as_string(); }
std::string status_of(const Expected<Value>& task) { return task.value().find("status")->as_string(); }

TEST(Tasks, ArePreferredByWhoSaysSo) {
  for (const char* prefer : {"respond-async", "wait=10, Respond-Async", "respond-async; foo=1"})
    EXPECT_TRUE(Tasks::is_preferred(request_of("a", prefer))) << prefer;
  for (const char* prefer : {"", "wait=10", "respond-asynchronously", "x=respond-async"})
    EXPECT_FALSE(Tasks::is_preferred(request_of("a", prefer))) << prefer;
}

TEST(Tasks, SayWhatTheWorkHasComeTo) {
  Tasks tasks;
  const Identity who{"a", Role::developer};
  const std::string good = id_of(tasks.begin(request_of("a"), false)), bad = id_of(tasks.begin(request_of("a"), false));
  EXPECT_EQ(status_of(tasks.find(good, who)), "running");
  Reply made;
  made.status = 201;
  made.body = Dict{{"name", "x"}};
  made.headers.emplace_back("Location", "/api/v1/backups/x");
  tasks.end(good, made);
  const Value done = tasks.find(good, who).value();
  EXPECT_EQ(done.find("status")->as_string(), "done");
  EXPECT_EQ(done.find("code")->as_integer(), 201);
  EXPECT_EQ(done.find("location")->as_string(), "/api/v1/backups/x");
  EXPECT_EQ(*done.find("result"), made.body);
  tasks.end(bad, refusal({Error{ErrorCode::conflict, "no", {}}}));
  const Value failed = tasks.find(bad, who).value();
  EXPECT_EQ(failed.find("status")->as_string(), "failed");
  EXPECT_EQ(failed.find("code")->as_integer(), 409);
  EXPECT_EQ(failed.find("errors")->as_list().front().find("code")->as_string(), "conflict");
}

TEST(Tasks, AreKeptWithSoManyBytes) {
  Tasks tasks;
  const Identity who{"a", Role::developer};
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < 4; ++i) {
    ids.push_back(id_of(tasks.begin(request_of("a"), false)));
    Reply large;
    large.body = Dict{{"text", std::string(Tasks::kMostBytes / 3, 'x')}};
    tasks.end(ids.back(), large);
  }
  EXPECT_EQ(tasks.find(ids[0], who).error().code, ErrorCode::not_found);
  EXPECT_EQ(tasks.find(ids[1], who).error().code, ErrorCode::not_found)
      << "with its quotation marks, it is more than a third";
  EXPECT_TRUE(tasks.find(ids[2], who));
  EXPECT_TRUE(tasks.find(ids[3], who));
  ids.push_back(id_of(tasks.begin(request_of("a"), false)));
  Reply larger;
  larger.body = Dict{{"text", std::string(Tasks::kMostBytes, 'x')}};
  tasks.end(ids.back(), larger);
  EXPECT_TRUE(tasks.find(ids.back(), who)) << "the last one, in any case";
  EXPECT_EQ(tasks.find(ids[3], who).error().code, ErrorCode::not_found);
}

TEST(Tasks, AreOfWhoHasAskedAndOfAdmins) {
  Tasks tasks;
  const std::string id = id_of(tasks.begin(request_of("a"), true));
  EXPECT_EQ(tasks.find(id, {"b", Role::developer}).error().code, ErrorCode::not_found);
  EXPECT_EQ(tasks.cancel(id, {"b", Role::developer}).error().code, ErrorCode::not_found);
  EXPECT_TRUE(tasks.find(id, {"b", Role::admin}));
}

TEST(Tasks, AreToldToStopIfTheyCanBe) {
  Tasks tasks;
  const Identity who{"a", Role::developer};
  const Request one = request_of("a"), other = request_of("a");
  const std::string id = id_of(tasks.begin(one, true)), fixed = id_of(tasks.begin(other, false));
  EXPECT_EQ(status_of(tasks.cancel(id, who)), "running");
  EXPECT_TRUE(*one.gone);
  EXPECT_EQ(tasks.cancel(fixed, who).error().code, ErrorCode::conflict);
  EXPECT_FALSE(*other.gone);
  tasks.end(id, refusal({Error{ErrorCode::unavailable, "stopped", {}}}));
  EXPECT_EQ(status_of(tasks.find(id, who)), "cancelled");
  EXPECT_EQ(tasks.cancel(id, who).error().code, ErrorCode::conflict);
}

TEST(Tasks, ThatTookTooLongAreNotCancelled) {
  Tasks tasks;
  const Identity who{"a", Role::developer};
  const Request request = request_of("a");
  const std::string id = id_of(tasks.begin(request, true));
  *request.gone = true;  // as work does that ends because its time is over
  tasks.end(id, refusal({Error{ErrorCode::too_large, "takes long", {}}}));
  EXPECT_EQ(status_of(tasks.find(id, who)), "failed");
}

// "3 of 10 bytes"; empty: nothing is said.
std::string progress_of(const Value& task) {
  const Value* progress = task.find("progress");
  if (!progress) return "";
  return std::to_string(progress->find("done")->as_integer()) + " of " +
         std::to_string(progress->find("total")->as_integer()) + ' ' + progress->find("unit")->as_string();
}

TEST(Tasks, SayHowFarTheirWorkIsOnceThatIsKnown) {
  Tasks tasks;
  const Identity who{"a", Role::developer};
  Request good = request_of("a"), bad = request_of("a");
  good.progress = std::make_shared<WorkProgress>();
  bad.progress = std::make_shared<WorkProgress>();
  const std::string done = id_of(tasks.begin(good, false)), failed = id_of(tasks.begin(bad, false));
  EXPECT_EQ(progress_of(tasks.find(done, who).value()), "");
  for (const Request* each : {&good, &bad}) {
    each->progress->begin(10, "bytes");
    each->progress->reach(3);
  }
  EXPECT_EQ(progress_of(tasks.find(done, who).value()), "3 of 10 bytes");
  tasks.end(done, Reply());
  tasks.end(failed, refusal({Error{ErrorCode::conflict, "no", {}}}));
  EXPECT_EQ(progress_of(tasks.find(done, who).value()), "10 of 10 bytes");
  EXPECT_EQ(progress_of(tasks.find(failed, who).value()), "3 of 10 bytes");
}

TEST(Tasks, HoldSoManyBytesOfBodies) {
  Tasks tasks;
  Request large = request_of("a");
  large.body = std::string(Tasks::kMostBytes / 2, ' ');
  const std::string first = id_of(tasks.begin(large, false));
  EXPECT_TRUE(tasks.begin(large, false));
  large.body = " ";
  EXPECT_EQ(tasks.begin(large, false).error().code, ErrorCode::unavailable);
  EXPECT_TRUE(tasks.begin(request_of("a"), false)) << "without a body";
  tasks.end(first, Reply());
  EXPECT_TRUE(tasks.begin(large, false));
}

TEST(Tasks, AreBounded) {
  Tasks tasks;
  const Identity who{"a", Role::developer};
  std::vector<std::string> running;
  for (std::size_t i = 0; i < Tasks::kMostRunning; ++i) running.push_back(id_of(tasks.begin(request_of("a"), false)));
  EXPECT_EQ(tasks.begin(request_of("a"), false).error().code, ErrorCode::unavailable);
  tasks.end(running.back(), Reply());
  for (std::size_t i = 0; i < Tasks::kMost; ++i) {
    const std::string id = id_of(tasks.begin(request_of("a"), false));
    tasks.end(id, Reply());
    EXPECT_TRUE(tasks.find(id, who));
  }
  EXPECT_EQ(tasks.find(running.back(), who).error().code, ErrorCode::not_found) << "the oldest that is over";
  EXPECT_EQ(status_of(tasks.find(running.front(), who)), "running");
}

}  // namespace
}  // namespace race::server
