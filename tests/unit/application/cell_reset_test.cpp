// The demo cell is as it was at the start after a reset, and nothing of before goes on in it.
#include <gmock/gmock.h>

#include <algorithm>

#include "core/value/json.h"
#include "server/cell/cell.h"

namespace race::server {
namespace {

using testing::Contains;

struct Responses final : services::HostObserver {
  void delivered(const services::Delivery& delivery) override {
    if (delivery.kind == services::Delivery::Kind::response)
      said.push_back(delivery.key + "." + delivery.name + (delivery.is_error ? " error " : " ") +
                     to_json(delivery.data));
  }
  void changed(const services::ServiceStatus&) override {}
  void logged(services::Time, const std::string& key, const std::string& text) override {
    lines.push_back(key + ": " + text);
  }
  std::vector<std::string> said, lines;
};

constexpr int kMoving = 300;  // steps until the robot is under way

struct CellReset : testing::Test {
  Responses observer;
  const std::unique_ptr<Cell> cell =
      Cell::create({.folder = RACE_SOURCE_DIR "/deploy/demo", .database = ":memory:", .own_threads = false}, observer)
          .value();
  Deadlines deadlines;

  const world::World& world() const { return const_cast<LocalWorld*>(cell->local_world())->world(); }
  void call(const std::string& service, const std::string& operation, List args) {
    cell->host().call({"core", ++calls_}, service, operation, std::move(args), {});
    cell->work();
  }
  void steps(int count) {
    for (int i = 0; i < count; ++i) cell->step();
  }
  Expected<Value> reset(bool with_database) {
    Expected<Value> answer = Value();
    bool answered = false;
    cell->reset(with_database, deadlines, [&](Expected<Value> value) {
      answer = std::move(value);
      answered = true;
    });
    while (cell->work()) {
    }
    EXPECT_TRUE(answered);
    return answer;
  }

 private:
  std::uint64_t calls_ = 0;
};

TEST_F(CellReset, ThatIsAskedForAgainBeforeItIsDoneIsOne) {
  for (const bool with_database : {true, false}) {
    std::vector<std::string> answers;
    for (int i = 0; i < 3; ++i)
      cell->reset(with_database, deadlines, [&](const Expected<Value>& answer) {
        answers.emplace_back(answer ? "reset" : name(answer.error().code));
      });
    EXPECT_THAT(answers, testing::ElementsAre("conflict", "conflict")) << "at once";
    while (cell->work()) {
    }
    EXPECT_THAT(answers, testing::ElementsAre("conflict", "conflict", "reset"));
    EXPECT_TRUE(reset(with_database)) << "the next is another one";
  }
  EXPECT_EQ(std::ranges::count(observer.lines, "robot: begins anew: the cell was reset"), 4);
}

TEST_F(CellReset, EndsAMotionAndPutsEverythingBack) {
  Responses other_observer;
  const auto fresh =
      Cell::create({.folder = RACE_SOURCE_DIR "/deploy/demo", .database = ":memory:", .own_threads = false},
                   other_observer)
          .value();
  call("robot", "move", {Dict{{"offset", List{0.0, 0.0, 0.1}}}});
  call("gripper", "grasp", {});
  steps(kMoving);
  ASSERT_NE(world().q(), world().scene().robot.q);
  ASSERT_EQ(reset(true).value(), parse_json(R"({"hands": [], "absent": []})").value());
  EXPECT_THAT(observer.said, Contains(testing::StartsWith(R"(robot.move error {"code":"unavailable")")));
  EXPECT_THAT(observer.lines, Contains("robot: begins anew: the cell was reset"));
  EXPECT_EQ(world().q(), world().scene().robot.q);
  steps(kMoving);
  for (int i = 0; i < kMoving; ++i) fresh->step();
  EXPECT_EQ(to_json(cell->local_world()->pose(0)), to_json(fresh->local_world()->pose(0)))
      << "nothing moves on its own";
  call("robot", "stop", {});
  EXPECT_EQ(observer.said.back(), "robot.stop null");
}

TEST_F(CellReset, LetsHandsGoAndPutsPartsBack) {
  const auto act = [&](const char* json) {
    const auto command = read_person_command(parse_json(json).value(), 60).value();
    return const_cast<LocalWorld*>(cell->local_world())->perform(command).has_value();
  };
  ASSERT_TRUE(act(R"({"act": "grab", "body": "link_5", "keep": 60})"));
  ASSERT_TRUE(act(R"({"act": "take", "part": "cube_blue"})"));
  EXPECT_EQ(reset(false).value(), parse_json(R"({"hands": [], "absent": []})").value());
}

TEST_F(CellReset, ReplacesTheValuesOfTheDatabaseIfAsked) {
  call("db", "add", {"own", 1});
  call("db", "remove", {"object_pose"});
  ASSERT_TRUE(reset(false));
  call("db", "get", {"own"});
  EXPECT_EQ(observer.said.back(), "db.get 1");
  ASSERT_TRUE(reset(true));
  call("db", "get", {"own"});
  EXPECT_THAT(observer.said.back(), testing::StartsWith(R"(db.get error {"code":"not_found")"));
  call("db", "get", {"object_pose"});
  EXPECT_THAT(observer.said.back(), testing::StartsWith(R"(db.get {"position":[0.55,)"));
}

TEST(CellOfProcesses, IsResetByNobodyHere) {
  Responses observer;
  Deadlines deadlines;
  const auto refusal = [&](const CellSetup& setup, bool with_database) {
    const auto cell = Cell::create(setup, observer).value();
    std::optional<Error> error;
    cell->reset(with_database, deadlines, [&](const Expected<Value>& value) { error = value.error(); });
    cell->stop();
    return error.value();
  };
  const std::string demo = RACE_SOURCE_DIR "/deploy/demo";
  EXPECT_EQ(refusal({.folder = "", .database = ":memory:", .remote = {"cell"}}, false).code, ErrorCode::conflict);
  EXPECT_EQ(refusal({.folder = demo, .database = ":memory:", .remote = {"database"}}, true).code, ErrorCode::conflict);
}

}  // namespace
}  // namespace race::server
