#include "services/arguments.h"

#include <gtest/gtest.h>

#include "core/rsm/document.h"
#include "core/value/json.h"

namespace race::services {
namespace {

const rsm::Service& model() {
  static const rsm::Service service = rsm::read_service_text(R"json({
    "operations": [{"name": "go", "parameters": [
      {"name": "to", "type": "string"},
      {"name": "speed", "type": "number", "min": 0, "max": 0.5, "value": 0.25},
      {"name": "via", "type": {"optional": "string"}}]}],
    "events": []})json",
                                                             "services/x")
                                          .value();
  return service;
}

std::string bind(List args, Dict kwargs = {}) {
  const auto bound = bind_arguments(model().operations[0], Call{1, "go", std::move(args), std::move(kwargs)});
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

}  // namespace
}  // namespace race::services
