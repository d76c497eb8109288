#include "server/handlers/idempotency.h"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <vector>

#include "server/http/refusal.h"

namespace race::server {
namespace {

Request request(const std::string& key, const std::string& body = "{}") {
  Request out;
  out.method = "POST";
  out.path = "/api/v1/cores";
  out.headers = {{"idempotency-key", key}};
  out.body = body;
  return out;
}

class Idempotency : public testing::Test {
 protected:
  /// The number of the answer, which is counted; a refusal's status.
  std::int64_t ask(const Request& asked) {
    const Reply reply = answer(asked, [this] { return make(); });
    return reply.status < 300 ? reply.body.as_integer() : reply.status;
  }
  /// The reply to a request that `make` answers at once.
  Reply answer(const Request& asked, const std::function<Reply()>& make) {
    Reply given;
    answers_.answer(
        asked, [&](const TakeReply& reply) { reply(make()); }, [&](Reply reply) { given = std::move(reply); });
    return given;
  }
  Reply make() {
    Reply reply;
    reply.status = 201;
    reply.body = ++made_;
    return reply;
  }

  std::int64_t made_ = 0;
  IdempotentAnswers answers_{{.answers = 3, .bytes = 100}};
};

TEST_F(Idempotency, AnswersTheSameRequestOnce) {
  EXPECT_EQ(ask(request("a")), 1);
  EXPECT_EQ(ask(request("a")), 1);
  EXPECT_EQ(ask(request("\"a\"")), 1) << "with or without quotation marks";
  EXPECT_EQ(ask(request("b")), 2);
  const Reply again = answer(request("b"), [this] { return make(); });
  EXPECT_EQ(again.status, 201);
  EXPECT_EQ(again.headers.back(), std::pair(std::string("Idempotency-Replayed"), std::string("true")));
}

TEST_F(Idempotency, AnswersEveryRequestWithoutAKey) {
  Request plain = request("a");
  plain.headers.clear();
  EXPECT_EQ(ask(plain), 1);
  EXPECT_EQ(ask(plain), 2);
}

TEST_F(Idempotency, RefusesAnotherRequestOfTheSameKey) {
  EXPECT_EQ(ask(request("a")), 1);
  EXPECT_EQ(ask(request("a", "[]")), 422);
  Request other = request("a");
  other.path = "/api/v1/backups";
  EXPECT_EQ(ask(other), 422);
  other = request("a");
  other.query = {{"x", "1"}};
  EXPECT_EQ(ask(other), 422);
  EXPECT_EQ(made_, 1);
}

TEST_F(Idempotency, RefusesTheSameRequestWhileItIsUnderWay) {
  const Reply first = answer(request("a"), [this] {
    EXPECT_EQ(ask(request("a")), 409);
    return make();
  });
  EXPECT_EQ(first.status, 201);
  EXPECT_EQ(ask(request("a")), 1);
}

TEST_F(Idempotency, KeepsAnAnswerThatComesLaterAndForgetsOneThatNeverComes) {
  TakeReply later;
  std::vector<int> replies;
  const auto ask_later = [&](const char* key) {
    answers_.answer(
        request(key), [&](TakeReply reply) { later = std::move(reply); },
        [&](const Reply& reply) { replies.push_back(reply.status); });
  };
  ask_later("a");
  EXPECT_EQ(ask(request("a")), 409);
  later(make());
  EXPECT_EQ(replies, std::vector{201});
  EXPECT_EQ(ask(request("a")), 1);
  ask_later("b");
  later = nullptr;
  EXPECT_EQ(replies.size(), 1U);
  EXPECT_EQ(ask(request("b")), 2);
}

TEST_F(Idempotency, KeepsNoRefusal) {
  const auto refuse = [] { return refusal(507, "storage", "the disk is full"); };
  EXPECT_EQ(answer(request("a"), refuse).status, 507);
  EXPECT_EQ(ask(request("a")), 1);
  EXPECT_THROW(answer(request("b"), []() -> Reply { throw std::runtime_error("a bug"); }), std::runtime_error);
  EXPECT_EQ(ask(request("b")), 2);
}

TEST_F(Idempotency, ForgetsTheOldestAnswers) {
  for (const char* key : {"a", "b", "c", "d"}) ask(request(key));
  EXPECT_EQ(ask(request("b")), 2);
  EXPECT_EQ(ask(request("a")), 5);
}

TEST_F(Idempotency, ForgetsAllWhenTheStoreIsAnotherOne) {
  ask(request("a"));
  answers_.clear();
  EXPECT_EQ(ask(request("a")), 2);
  EXPECT_EQ(ask(request("a")), 2);
}

TEST_F(Idempotency, KeepsSoManyBytes) {
  ask(request("a"));
  const auto large = [](std::size_t bytes) {
    Reply reply;
    reply.body = std::string(bytes - 2, 'x');  // and quotation marks
    return reply;
  };
  EXPECT_EQ(answer(request("b"), [&] { return large(99); }).status, 200);
  EXPECT_EQ(ask(request("a")), 1) << "100 bytes in all";
  EXPECT_EQ(answer(request("c"), [&] { return large(101); }).status, 200);
  EXPECT_EQ(ask(request("c")), 2) << "too large to be kept";
  EXPECT_EQ(ask(request("a")), 3);
}

TEST_F(Idempotency, RefusesWhatIsNoKey) {
  for (const std::string& key :
       {std::string(), std::string("\"\""), std::string("a b"), std::string(65, 'a'), std::string("a\"")})
    EXPECT_EQ(ask(request(key)), 400) << key;
  Request twice = request("a");
  twice.headers.push_back(twice.headers.front());
  EXPECT_EQ(ask(twice), 400);
  EXPECT_EQ(ask(request(std::string(64, 'a'))), 1);
}

}  // namespace
}  // namespace race::server
