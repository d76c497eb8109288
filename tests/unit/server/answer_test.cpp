// A request is answered once, whatever becomes of what was to answer it.
#include "server/http/answer.h"

#include <gtest/gtest.h>

#include <new>
#include <optional>
#include <vector>

namespace race::server {
namespace {

Reply with_status(int status) {
  Reply reply;
  reply.status = status;
  return reply;
}

TEST(Answer, TakesTheFirstReply) {
  std::vector<int> replies;
  {
    const Answer answer([&](const Reply& reply) { replies.push_back(reply.status); });
    const auto reply_with = [copy = answer](int status) { copy(with_status(status)); };
    reply_with(201);
    answer(with_status(404));
  }
  EXPECT_EQ(replies, std::vector{201});
}

TEST(Answer, IsUnavailableIfTheLastOfItGoesWithoutAReply) {
  std::vector<int> replies;
  std::optional<Answer> answer(std::in_place, [&](const Reply& reply) { replies.push_back(reply.status); });
  std::optional<Answer> copy = answer;
  answer.reset();
  EXPECT_TRUE(replies.empty());
  copy.reset();
  EXPECT_EQ(replies, std::vector{503});
}

TEST(Answer, TakesAnotherReplyIfTheFirstCouldNotBeDelivered) {
  std::vector<int> replies;
  const Answer answer([&](const Reply& reply) {
    if (reply.status == 200) throw std::bad_alloc();
    replies.push_back(reply.status);
  });
  EXPECT_THROW(answer(with_status(200)), std::bad_alloc);
  answer(with_status(503));
  EXPECT_EQ(replies, std::vector{503});
}

}  // namespace
}  // namespace race::server
