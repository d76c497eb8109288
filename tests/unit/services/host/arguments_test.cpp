#include "services/arguments.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/rsm/document.h"
#include "core/value/json.h"

namespace race::services {
namespace {

const rsm::Service& model() {
  static const rsm::Service service = rsm::read_service_text(R"json({
    "operations": [{"name": "go", "parameters": [
      {"name": "to", "type": "string"},
      {"name": "speed", "type": "number", "min": 0, "max": 0.5, "value": 0.25},
      {"name": "via", "type": {"optional": "string"}}]},
    {"name": "wait", "parameters": [
      {"name": "least", "type": "number", "min": 0, "value": 0},
      {"name": "most", "type": "number", "max": 10, "value": 0}]}],
    "events": []})json",
                                                             "services/x")
                                          .value();
  return service;
}

std::string bind(List args, Dict kwargs = {}, const std::string& operation = "go") {
  const auto bound =
      bind_arguments(*find_operation(model(), operation), Call{1, operation, std::move(args), std::move(kwargs)});
  return bound ? to_json(Value(*bound)) : std::string(name(bound.error().code)) + " " + bound.error().path;
}

TEST(Arguments, BindByPositionAndByName) {
  EXPECT_EQ(bind({"home", 0.5}), R"({"to":"home","speed":0.5})");
  EXPECT_EQ(bind({}, {{"via", "door"}, {"to", "home"}}), R"({"to":"home","speed":0.25,"via":"door"})");
}

TEST(Arguments, LackingOnesHaveTheirDeclaredValue) { EXPECT_EQ(bind({"home"}), R"({"to":"home","speed":0.25})"); }

TEST(Arguments, AreRefusedByName) {
  EXPECT_EQ(bind({}), "missing to");
  EXPECT_EQ(bind({7}), "type to");
  EXPECT_EQ(bind({"home", 0.6}), "out_of_range speed");
  EXPECT_EQ(bind({"home", -1}), "out_of_range speed");
  EXPECT_EQ(bind({"home"}, {{"to", "there"}}), "type to");
  EXPECT_EQ(bind({"home"}, {{"tempo", 1}}), "type ");
  EXPECT_EQ(bind({"home", 0.1, "door", 4}), "type ");
}

// A task can compute them, though JSON cannot say them: NaN is on neither side of a limit, so it is out of each.
TEST(Arguments, ThatAreNoFiniteNumberAreOutOfAnyRange) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double wrong : {kNan, kInfinity, -kInfinity})
    EXPECT_EQ(bind({"home", wrong}), "out_of_range speed") << wrong;
  EXPECT_EQ(bind({kNan}, {}, "wait"), "out_of_range least");
  EXPECT_EQ(bind({-kInfinity}, {}, "wait"), "out_of_range least");
  EXPECT_EQ(bind({0, kNan}, {}, "wait"), "out_of_range most");
  EXPECT_EQ(bind({0, kInfinity}, {}, "wait"), "out_of_range most");
}

}  // namespace
}  // namespace race::services
