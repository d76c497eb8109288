// Both ends of a world, without sockets: the server's, and that of the process that has it.
#include "services/remote/remote_world.h"

#include <gmock/gmock.h>

#include <limits>

#include "core/value/json.h"
#include "services/remote/process_host.h"

namespace race::remote {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> all_of(SendQueue& queue) {
  std::vector<std::string> all;
  while (auto encoded = queue.pop()) all.push_back(encoded->bytes);
  return all;
}

Message message_of(Kind kind, std::int64_t number, Value value) {
  Message message;
  message.kind = kind;
  message.number = number;
  message.value = std::move(value);
  return message;
}

struct RemoteWorldTest : testing::Test {
  void come(const std::shared_ptr<SendQueue>& queue) { world.connect(queue, world.check(1).value()); }
  void act(const std::string& what) {
    const auto asked = [this] { return wanted; };
    world.execute(what, asked, [this, what](const Expected<Value>& done) {
      answers.push_back(what + ": " + (done ? to_json(*done) : to_string(done.error())));
    });
  }
  Expected<void> ready(std::int64_t number) { return world.announce(message_of(Kind::ready, number, {})); }
  /// The act, and the process is ready for it.
  void begin(const std::string& what, std::int64_t number) {
    act(what);
    ASSERT_TRUE(ready(number));
  }
  std::vector<std::string> said() { return all_of(*process); }
  /// What a value must be: no text.
  static Expected<void> no_text(const Value& value) {
    if (value.is_string()) return unexpected(ErrorCode::type, "must be no text");
    return {};
  }
  static Expected<RemoteWorld::Rules> no_texts(const Value& value) {
    if (auto good = no_text(value); !good) return tl::unexpected(good.error());
    return RemoteWorld::Rules{no_text, no_text};
  }

  services::WorldClock clock;
  bool wanted = true;
  std::vector<std::string> answers, shown;
  RemoteWorld world{clock, no_texts, [this](const Value& pose) { shown.push_back(to_json(pose)); }};
  std::shared_ptr<SendQueue> process = std::make_shared<SendQueue>();
};

TEST_F(RemoteWorldTest, WithoutAProcessAnActIsUnavailableAtOnce) {
  act("push");
  EXPECT_THAT(answers, ElementsAre(HasSubstr("push: : unavailable")));
  EXPECT_TRUE(world.world().is_null());
}

TEST_F(RemoteWorldTest, AnAnswerReachesTheActOfItsNumber) {
  clock.set(2);
  come(process);
  act("push");
  act("take");
  EXPECT_THAT(said(),
              ElementsAre(R"({"type":"offer","number":1,"time":2.0})", R"({"type":"offer","number":2,"time":2.0})"));
  ASSERT_TRUE(ready(2));
  ASSERT_TRUE(ready(1));
  EXPECT_THAT(said(), ElementsAre(R"({"type":"act","number":2,"act":"take","time":2.0})",
                                  R"({"type":"act","number":1,"act":"push","time":2.0})"));
  const Value error = Dict{{"path", "body"}, {"code", "conflict"}, {"message", "is away"}};
  ASSERT_TRUE(world.announce(message_of(Kind::failed, 2, error)));
  ASSERT_TRUE(world.announce(message_of(Kind::done, 1, 7)));
  EXPECT_THAT(answers, ElementsAre("take: body: conflict: is away", "push: 7"));
}

// A process that hangs and wakes does nothing for who was told that nothing is done.
TEST_F(RemoteWorldTest, AnActThatNobodyWantsAnyMoreIsNotToldToTheProcess) {
  come(process);
  act("push");
  said();
  wanted = false;
  ASSERT_TRUE(ready(1));
  EXPECT_THAT(said(), IsEmpty());
  EXPECT_THAT(answers, IsEmpty());
  EXPECT_EQ(ready(1).error().code, ErrorCode::conflict);
}

TEST_F(RemoteWorldTest, OnlyWhatHasBegunIsAnsweredAndNothingBeginsTwice) {
  come(process);
  act("push");
  EXPECT_EQ(world.announce(message_of(Kind::done, 1, 7)).error().code, ErrorCode::conflict);
  ASSERT_TRUE(ready(1));
  EXPECT_EQ(ready(1).error().code, ErrorCode::conflict);
  EXPECT_EQ(ready(2).error().code, ErrorCode::conflict);
  ASSERT_TRUE(world.announce(message_of(Kind::done, 1, 7)));
  EXPECT_THAT(answers, ElementsAre("push: 7"));
}

TEST_F(RemoteWorldTest, AWorldThatDoesNotFitIsRefused) { EXPECT_FALSE(world.check("flat")); }

TEST_F(RemoteWorldTest, WhyAnActIsUnavailableIsSaid) {
  come(process);
  process->close();
  act("push");
  EXPECT_THAT(answers, ElementsAre(HasSubstr("unavailable: the process of the cell takes nothing more")));
}

TEST_F(RemoteWorldTest, WhatWaitsIsUnavailableWhenTheProcessIsLostAndStaysSo) {
  come(process);
  begin("push", 1);
  act("take");
  world.connect(nullptr, {});
  EXPECT_THAT(answers, ElementsAre(HasSubstr("push: : unavailable"), HasSubstr("take: : unavailable")));
  EXPECT_TRUE(world.world().is_null());
  come(std::make_shared<SendQueue>());
  EXPECT_EQ(world.announce(message_of(Kind::done, 1, 7)).error().code, ErrorCode::conflict)
      << "the act of one process is not the next one's to answer";
  EXPECT_EQ(answers.size(), 2U);
}

TEST_F(RemoteWorldTest, WhatDoesNotFitIsAnErrorAndAnswersNobody) {
  come(process);
  begin("push", 1);
  const auto refused = [&](Kind kind, Value value) {
    const auto got = world.announce(message_of(kind, 1, std::move(value)));
    return got ? "none" : to_string(got.error());
  };
  world.watch(true);
  EXPECT_THAT(refused(Kind::pose, "here"), HasSubstr("no text"));
  EXPECT_THAT(refused(Kind::done, "done"), HasSubstr("no text"));
  EXPECT_THAT(refused(Kind::failed, 1), HasSubstr("type"));
  EXPECT_THAT(refused(Kind::failed, Dict{{"path", ""}, {"code", "tired"}, {"message", ""}}), HasSubstr("no code"));
  const std::string long_text(kNameBytes + 1, 'x');
  EXPECT_THAT(refused(Kind::failed, Dict{{"path", ""}, {"code", "io"}, {"message", long_text}}), HasSubstr("at most"));
  EXPECT_THAT(shown, IsEmpty());
  EXPECT_THAT(answers, IsEmpty());
}

TEST_F(RemoteWorldTest, AFewActsWaitNoMore) {
  come(process);
  for (std::size_t i = 0; i < RemoteWorld::kMaxPendingCommands; ++i) act("push");
  EXPECT_THAT(answers, IsEmpty());
  act("push");
  EXPECT_THAT(answers, ElementsAre(HasSubstr("unavailable: 100 acts wait for the cell already")));
  EXPECT_EQ(said().size(), RemoteWorld::kMaxPendingCommands);
}

TEST_F(RemoteWorldTest, PosesAreWantedWhileSomebodyWatchesFromEachProcessThatComes) {
  world.watch(true);
  come(process);
  world.watch(true);
  EXPECT_THAT(said(), ElementsAre(R"({"type":"watch","on":true,"time":0.0})"));
  ASSERT_TRUE(world.announce(message_of(Kind::pose, 0, 5)));
  world.watch(false);
  EXPECT_THAT(said(), ElementsAre(R"({"type":"watch","on":false,"time":0.0})"));
  ASSERT_TRUE(world.announce(message_of(Kind::pose, 0, 6))) << "it was on its way";
  EXPECT_THAT(shown, ElementsAre("5"));
  world.connect(nullptr, {});
  come(process);
  EXPECT_THAT(said(), IsEmpty());
}

struct ProcessWithWorld : testing::Test {
  ProcessWithWorld() {
    process.set_world({1,
                       [this](const Value& act) -> Expected<Value> {
                         if (act == Value("kick")) return unexpected(ErrorCode::type, refusal, refusal);
                         return Value(List{act, state});
                       },
                       [this](bool on) { watched = on; }});
    process.connect(server);
  }
  std::vector<std::string> act(const std::string& what) {
    EXPECT_TRUE(process.handle(message_of(Kind::act, 4, what)));
    return all_of(server);
  }
  SendQueue server;
  ProcessHost process;
  double state = 0.5;
  std::string refusal = "be kind";
  bool watched = false;
};

TEST_F(ProcessWithWorld, GoesWithTheHello) { EXPECT_EQ(process.hello().world, Value(1)); }

TEST_F(ProcessWithWorld, IsReadyInItsTurn) {
  ASSERT_TRUE(process.handle(message_of(Kind::offer, 9, {})));
  EXPECT_THAT(all_of(server), ElementsAre(R"({"type":"ready","number":9})"));
}

TEST_F(ProcessWithWorld, AnActIsAnsweredOrRefusedWithItsNumber) {
  EXPECT_THAT(act("push"), ElementsAre(R"({"type":"done","number":4,"person":["push",0.5]})"));
  EXPECT_THAT(
      act("kick"),
      ElementsAre(R"({"type":"failed","number":4,"error":{"path":"be kind","code":"type","message":"be kind"}})"));
  state = std::numeric_limits<double>::infinity();
  EXPECT_THAT(act("push"),
              ElementsAre(HasSubstr(R"("type":"failed","number":4,"error":{"path":"","code":"constant")")));
}

// What an act names may be of any length; the server loses who says more than a name holds.
TEST_F(ProcessWithWorld, ALongRefusalIsCutToWhatTheServerTakes) {
  refusal = std::string(kNameBytes - 1, 'x') + "é";
  const auto said = act("kick");
  ASSERT_EQ(said.size(), 1U);
  services::WorldClock clock;
  RemoteWorld there(clock, [](const Value&) { return Expected<RemoteWorld::Rules>(); }, {});
  there.connect(std::make_shared<SendQueue>(), {});
  std::string answered;
  for (int number = 1; number <= 4; ++number) {
    const auto confirm = [] { return true; };
    there.execute("kick", confirm,
                  [&](const Expected<Value>& done) { answered = done ? "done" : to_string(done.error()); });
    ASSERT_TRUE(there.announce(message_of(Kind::ready, number, {})));
  }
  const auto taken = there.announce(decode({said[0], false}, Reader::server).value());
  ASSERT_TRUE(taken) << to_string(taken.error());
  const std::string text(kNameBytes - 1, 'x');
  EXPECT_EQ(answered, text + ": type: " + text);
}

TEST_F(ProcessWithWorld, AnAnswerThatIsTooLargeIsRefused) {
  EXPECT_THAT(act(std::string(kMessageBytes, 'x')),
              ElementsAre(HasSubstr(R"("type":"failed","number":4,"error":{"path":"","code":"too_large")")));
}

TEST_F(ProcessWithWorld, OnlyTheNewestPoseWaits) {
  process.send_pose(1);
  process.send_pose(2);
  process.send_pose(3);
  EXPECT_THAT(all_of(server), ElementsAre(R"({"type":"pose","pose":3})"));
  process.send_pose(std::numeric_limits<double>::quiet_NaN());
  EXPECT_THAT(all_of(server), IsEmpty());
}

TEST_F(ProcessWithWorld, HearsWhetherPosesAreWanted) {
  Message watch = message_of(Kind::watch, 0, {});
  watch.on = true;
  ASSERT_TRUE(process.handle(watch));
  EXPECT_TRUE(watched);
}

TEST(ProcessWithoutWorld, RefusesCommands) {
  ProcessHost process;
  EXPECT_EQ(process.handle(message_of(Kind::act, 1, "push")).error().code, ErrorCode::not_found);
  EXPECT_TRUE(process.hello().world.is_null());
}

}  // namespace
}  // namespace race::remote
