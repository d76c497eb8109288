// The cell's steps that fail, and what its operator remembers.
#include "server/cell/cell.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>

#include "server/cell/operator.h"
#include "services/failures.h"

namespace race::server {
namespace {

struct Silent final : services::HostObserver {
  void delivered(const services::Delivery&) override {}
  void changed(const services::ServiceStatus&) override {}
  void logged(services::Time, const std::string&, const std::string&) override {}
};

TEST(Cell, AStepThatFailsIsReportedOnceAndTheCellGoesOn) {
  std::atomic<int> reports{0}, steps{0};
  std::atomic<bool> fails{true};
  services::set_failure_handler([&](const std::string& text) {
    EXPECT_EQ(text, "a step of the cell failed: broken");
    ++reports;
  });
  Silent observer;
  const auto cell = Cell::create({.folder = "", .database = ":memory:"}, observer).value();
  cell->before_step([&] {
    ++steps;
    if (fails) throw std::runtime_error("broken");
  });
  cell->start_real_time();
  const auto wait_for_steps = [&](int more) {
    for (const int end = steps + more; steps < end;) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  wait_for_steps(5);
  EXPECT_EQ(reports, 1) << "of five that failed";
  fails = false;
  wait_for_steps(5);
  EXPECT_GT(cell->clock().now(), 0);
  fails = true;
  wait_for_steps(5);
  EXPECT_EQ(reports, 2);
  cell->stop();
  services::set_failure_handler({});
}

TEST(Operator, StandsBeforeDisplaysAtTheirPlaces) {
  display::Screens screens;
  auto script = read_operator_text(R"({"operator": 1, "acts": [],
    "displays": ["main", {"name": "phone", "place": "gripper"}, {"name": "panel"}]})");
  ASSERT_TRUE(script) << to_string(script.error().front());
  const Operator person(std::move(*script), screens, [](const std::string& line) { ADD_FAILURE() << line; });
  ASSERT_TRUE(screens.show("@gripper", {"Lead the arm", "", {}}));
  EXPECT_TRUE(screens.content("phone")->message);
  EXPECT_FALSE(screens.content("main")->message);
  EXPECT_FALSE(screens.content("panel")->message);
}

TEST(Operator, StandsBeforeNoDisplayThatCannotBe) {
  struct Wrong {
    const char *display, *path;
    ErrorCode code;
  };
  for (const Wrong& wrong : {Wrong{"\"a b\"", "displays/0", ErrorCode::name}, Wrong{"7", "displays/0", ErrorCode::type},
                             Wrong{R"({"place": "gripper"})", "displays/0", ErrorCode::missing},
                             Wrong{R"({"name": "phone", "place": "@gripper"})", "displays/0", ErrorCode::name},
                             Wrong{R"({"name": "phone", "at": "gripper"})", "displays/0", ErrorCode::unknown_field}}) {
    const auto script =
        read_operator_text(R"({"operator": 1, "acts": [], "displays": [)" + std::string(wrong.display) + "]}");
    ASSERT_FALSE(script) << wrong.display;
    ASSERT_EQ(script.error().size(), 1U) << wrong.display;
    EXPECT_EQ(script.error()[0].code, wrong.code) << wrong.display;
    EXPECT_EQ(script.error()[0].path, wrong.path) << wrong.display;
  }
}

TEST(Operator, RemembersOnlyNodesThatItsScriptNamesAndOfCoresThatAreThere) {
  display::Screens screens;
  auto script = read_operator_text(R"({"operator": 1, "acts": [
    {"when": {"active": "Root/A"}, "do": {"act": "release"}},
    {"when": {"inactive": "Root/B"}, "do": {"act": "release"}}]})");
  ASSERT_TRUE(script) << to_string(script.error().front());
  Operator person(std::move(*script), screens, [](const std::string&) {});
  for (int i = 0; i < 1000; ++i) {
    const std::string core = std::to_string(i);
    person.state(core, {"Root", "Root/A", "Root/" + core});
    for (const bool on : {true, false}) person.changed(core, Dict{{"Root/B", on}, {"Root/also/" + core, on}}, {});
    person.removed(core);
  }
  EXPECT_EQ(person.remembered(), 1U) << "that Root/B was active once";
  person.state("1", {"Root", "Root/A"});
  EXPECT_EQ(person.remembered(), 2U);
}

}  // namespace
}  // namespace race::server
