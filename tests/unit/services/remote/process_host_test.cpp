#include "services/remote/process_host.h"

#include <gmock/gmock.h>

#include <atomic>
#include <thread>
#include <tuple>

#include "core/value/json.h"
#include "tests/unit/services/remote/lamp.h"

namespace race::remote {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct ProcessHostTest : testing::Test {
  ProcessHostTest() {
    auto made = std::make_unique<Lamp>(process.declare("lamp", "lamp"));
    lamp = made.get();
    process.attach("lamp", std::move(made));
    process.connect(server);
  }
  Message message(Kind kind, double time = 0) {
    Message made;
    made.kind = kind;
    made.key = "lamp";
    made.time = time;
    return made;
  }
  void call(std::string operation, services::CallId id) {
    Message made = message(Kind::call);
    made.name = std::move(operation);
    made.call = id;
    ASSERT_TRUE(process.handle(std::move(made)));
  }
  std::vector<std::string> said() {
    std::vector<std::string> all;
    while (auto encoded = server.pop()) all.push_back(encoded->bytes);
    return all;
  }
  SendQueue server;
  ProcessHost process;
  Lamp* lamp = nullptr;
};

TEST_F(ProcessHostTest, SaysWhatItBrings) {
  const Message hello = process.hello();
  EXPECT_EQ(hello.number, kProtocol);
  const Value& lamp = hello.value.as_list().at(0);
  EXPECT_EQ(lamp.find("key")->as_string(), "lamp");
  EXPECT_EQ(lamp.find("rsm")->find("init")->as_string(), "Dark");
}

TEST_F(ProcessHostTest, TellsTheServerWhatAComponentAnnounces) {
  call("on", 5);
  EXPECT_THAT(said(), ElementsAre(R"({"type":"transition","key":"lamp","id":"t1","call":5})",
                                  R"({"type":"result","key":"lamp","call":5,"value":null})",
                                  R"({"type":"event","key":"lamp","name":"lit","data":1})"));
}

TEST_F(ProcessHostTest, HandsOverViolationsIfItAskedForThem) {
  EXPECT_FALSE(process.hello().on);
  process.ask_for_violations();
  EXPECT_TRUE(process.hello().on);
  Message violation = message(Kind::violation, 2);
  violation.name = "type";
  violation.value = "expected a number";
  violation.call = 7;
  violation.service = "on";
  ASSERT_TRUE(process.handle(std::move(violation)));
  ASSERT_EQ(lamp->violations.size(), 1U);
  const services::Violation& told = lamp->violations.front();
  EXPECT_EQ(std::tie(told.rule, told.message, told.call, told.operation),
            std::make_tuple("type", "expected a number", services::CallId{7}, "on"));
}

TEST_F(ProcessHostTest, SaysNothingWhileItIsNotConnected) {
  process.disconnect();
  call("on", 5);
  EXPECT_THAT(said(), IsEmpty());
}

TEST_F(ProcessHostTest, AResultThatCannotBeSentBecomesAnError) {
  lamp->answer = std::numeric_limits<double>::infinity();
  call("on", 5);
  EXPECT_THAT(said()[1], HasSubstr(R"("type":"error","key":"lamp","call":5,"error":{"code":"constant")"));
}

TEST_F(ProcessHostTest, HaltsOnceWhenTheServerIsSilent) {
  const auto pass = [&](int milliseconds) {
    for (int step = 0; step < milliseconds; ++step) ASSERT_TRUE(process.step());
  };
  pass(5000);
  EXPECT_EQ(lamp->halts, 0) << "it is not welcome yet";
  Message welcome = message(Kind::welcome);
  welcome.number = 400;
  ASSERT_TRUE(process.handle(welcome));
  pass(395);
  EXPECT_EQ(lamp->halts, 0);
  pass(10);
  EXPECT_EQ(lamp->halts, 1);
  pass(5000);
  EXPECT_EQ(lamp->halts, 1) << "once for each silence";
  ASSERT_TRUE(process.handle(message(Kind::ping)));
  pass(395);
  EXPECT_EQ(lamp->halts, 1);
  pass(10);
  EXPECT_EQ(lamp->halts, 2);
}

TEST_F(ProcessHostTest, HandsALimitOfTheSpeedToItsComponent) {
  Message limit = message(Kind::limit_speed);
  limit.value = 0.25;
  ASSERT_TRUE(process.handle(limit));
  limit.value = nullptr;
  ASSERT_TRUE(process.handle(limit));
  EXPECT_THAT(lamp->wishes, ElementsAre("at most 0.25 after 0 calls", "at most any after 0 calls"));
}

TEST_F(ProcessHostTest, AnswersAPingWithItsNumber) {
  Message ping = message(Kind::ping, 2.0);
  ping.number = 9;
  ASSERT_TRUE(process.handle(ping));
  EXPECT_THAT(said(), ElementsAre(R"({"type":"pong","number":9})"));
}

TEST_F(ProcessHostTest, RefusesAMessageForNoComponent) {
  Message made = message(Kind::wanted);
  made.key = "heater";
  EXPECT_EQ(process.handle(made).error().code, ErrorCode::not_found);
}

TEST_F(ProcessHostTest, KeepsToTheServersTime) {
  ASSERT_TRUE(process.handle(message(Kind::welcome, 10.0)));
  EXPECT_DOUBLE_EQ(process.clock().now(), 10.0);
  process.step();
  EXPECT_DOUBLE_EQ(process.clock().now(), 10.001);
  ASSERT_TRUE(process.handle(message(Kind::ping, 10.02)));
  EXPECT_DOUBLE_EQ(process.clock().now(), 10.001) << "that is near enough";
  ASSERT_TRUE(process.handle(message(Kind::ping, 11.0)));
  EXPECT_DOUBLE_EQ(process.clock().now(), 11.0);
  ASSERT_TRUE(process.handle(message(Kind::ping, 10.9)));
  for (int i = 0; i < 100; ++i) process.step();
  EXPECT_NEAR(process.clock().now(), 11.0, 0.0015) << "time never goes back: it waits";
  process.step();
  process.step();
  EXPECT_GT(process.clock().now(), 11.0015);
}

TEST_F(ProcessHostTest, GivesAnswersThatAreDueInTheirTime) {
  int answered = 0;
  const auto reservation = lamp->host.reserve(0.003);
  lamp->host.fulfil(reservation, [&] { ++answered; });
  process.step();
  process.step();
  EXPECT_EQ(answered, 0);
  process.step();
  EXPECT_EQ(answered, 1);
}

TEST_F(ProcessHostTest, HandsPacketsOver) {
  Message made = message(Kind::packet, 4.0);
  made.service = "camera";
  made.name = "images";
  made.bytes.resize(3);
  ASSERT_TRUE(process.handle(std::move(made)));
  EXPECT_THAT(lamp->packets, ElementsAre("camera.images at 4.0: 3 bytes"));
}

TEST_F(ProcessHostTest, HandlesInItsStepWhatItHasReceivedInOrder) {
  for (const services::CallId id : {5, 6}) {
    Message made = message(Kind::call);
    made.name = "burn";
    made.call = id;
    EXPECT_TRUE(process.receive(std::move(made), 10));
  }
  EXPECT_THAT(lamp->calls, IsEmpty());
  EXPECT_TRUE(process.step());
  ASSERT_EQ(lamp->calls.size(), 2U);
  EXPECT_EQ(lamp->calls[0].id, 5U);
}

TEST_F(ProcessHostTest, SaysWhatDoesNotFitOfWhatItHasReceived) {
  Message made = message(Kind::wanted);
  made.key = "heater";
  EXPECT_TRUE(process.receive(std::move(made), 10));
  EXPECT_EQ(process.step().error().code, ErrorCode::not_found);
}

TEST_F(ProcessHostTest, OfTheReceivedPacketsOfAFlowTheNewestWaits) {
  const auto receive = [&](const char* flow, double time) {
    Message made = message(Kind::packet, time);
    made.service = "camera";
    made.name = flow;
    return process.receive(std::move(made), SendQueue::kBytes / 3);
  };
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(receive("images", i));
  EXPECT_TRUE(receive("clouds", 1));
  EXPECT_TRUE(receive("depths", 1)) << "is dropped";
  EXPECT_TRUE(process.step());
  EXPECT_THAT(lamp->packets, ElementsAre("camera.images at 99.0: 0 bytes", "camera.clouds at 1.0: 0 bytes"));
}

TEST_F(ProcessHostTest, ReceivesNoMoreThanMayWait) {
  Message made = message(Kind::call);
  made.name = "burn";
  std::size_t received = 0;
  while (received < 1000 && process.receive(made, 1'000'000)) ++received;
  EXPECT_EQ(received, SendQueue::kBytes / 1'000'256);
  EXPECT_FALSE(process.receive(made, 1)) << "the connection is to end";
}

TEST_F(ProcessHostTest, EndsTheConnectionWhenAResultFindsNoRoom) {
  while (server.push({std::string(1'000'000, 'x')}, "flow" + std::to_string(server.size()))) {
  }
  lamp->answer = std::string(1'000'000, 'x');
  call("on", 5);
  EXPECT_TRUE(server.overflowed());
}

TEST_F(ProcessHostTest, AsksTheServerAndWaitsForItsReply) {
  EXPECT_EQ(process.request("lamp", "colour", {}).error().code, ErrorCode::unavailable) << "it is not welcome yet";
  ASSERT_TRUE(process.handle(message(Kind::welcome)));
  std::string asked;
  std::atomic<int> looks = 0;  // of who waits
  std::atomic<bool> answered = false;
  process.connect(server, [&] { return ++looks < 0; });
  std::thread there([&] {
    std::optional<EncodedMessage> encoded;
    while (!(encoded = server.pop())) std::this_thread::yield();
    asked = encoded->bytes;
    for (const int number : {7, 1}) {
      Message reply;
      reply.kind = Kind::reply;
      reply.number = number;
      reply.value = number;
      process.handle_reply(reply);
      for (const int before = looks; looks < before + 2 && !answered;) std::this_thread::yield();
    }
  });
  const auto answer = process.request("lamp", "colour", {{"of", "glass"}});
  answered = true;
  there.join();
  ASSERT_TRUE(answer);
  EXPECT_EQ(*answer, Value(1)) << "the reply of that number, no other";
  EXPECT_EQ(asked, R"({"type":"request","key":"lamp","number":1,"function":"colour","arguments":{"of":"glass"}})");
}

TEST_F(ProcessHostTest, WaitsForNoReplyWhenTheConnectionHasEnded) {
  std::atomic<bool> over = false;
  process.connect(server, [&] { return over.load(); });
  ASSERT_TRUE(process.handle(message(Kind::welcome)));
  std::thread there([&] {
    while (!server.pop()) std::this_thread::yield();
    over = true;
  });
  EXPECT_EQ(process.request("lamp", "colour", {}).error().code, ErrorCode::unavailable);
  there.join();
}

TEST_F(ProcessHostTest, WaitsForNoReplyToWhatCannotBeSent) {
  ASSERT_TRUE(process.handle(message(Kind::welcome)));
  server.close();
  EXPECT_EQ(process.request("lamp", "colour", {}).error().code, ErrorCode::unavailable);
}

TEST_F(ProcessHostTest, TellsAComponentThatThereIsNews) {
  int news = 0;
  process.on_host_change("lamp", [&] { ++news; });
  ASSERT_TRUE(process.handle(message(Kind::news)));
  EXPECT_EQ(news, 1);
}

TEST_F(ProcessHostTest, CutsALongLogBetweenCharacters) {
  std::string text(kNameBytes - 1, 'x');
  lamp->host.log(text + "é");
  EXPECT_EQ(said().at(0), R"({"type":"log","key":"lamp","text":")" + text + "\"}");
}

}  // namespace
}  // namespace race::remote
