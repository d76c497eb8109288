#include "services/display/display.h"

#include <gmock/gmock.h>

#include <limits>
#include <tuple>
#include <utility>

#include "core/value/json.h"
#include "services/display/remote_display_backend.h"
#include "tests/unit/services/display/screens_bench.h"

namespace race::display {
namespace {

using services::Delivery;
using testing::ElementsAre;
using testing::IsEmpty;

struct DisplayTest : ScreensBench<RemoteDisplayBackend> {
  explicit DisplayTest(bool elsewhere) : ScreensBench("display", answer_display_request) {
    bench.add<Display>("display", elsewhere ? static_cast<DisplayBackend&>(remote) : screens, std::string());
  }

  void connect(const std::string& display, const std::string& place = {}) {
    connections[display] = screens.connect(display, false, place).value();
    pass(0.001);
  }
  void disconnect(const std::string& display) {
    screens.disconnect(connections[display]);
    pass(0.001);
  }
  void answer(const std::string& display, Value value) {
    ASSERT_TRUE(screens.answer(display, std::move(value)));
    pass(0.001);
  }
  std::string state() const { return *bench.host.service("display")->state; }
  /// Events so far as "name data".
  std::vector<std::string> events() const {
    std::vector<std::string> all;
    for (const Delivery& each : bench.deliveries)
      if (each.kind == Delivery::Kind::event) all.push_back(each.name + " " + to_json(each.data));
    return all;
  }
  /// Of the last response, the argument that it complains of.
  std::string complaint() const {
    const Value* argument = bench.deliveries.back().data.find("argument");
    return argument ? argument->as_string() : "";
  }

  std::map<std::string, Screens::ConnectionId> connections;
};

/// Correct calls: the monitor must find no violation.
struct DisplayInOrder : DisplayTest, testing::WithParamInterface<bool> {
  DisplayInOrder() : DisplayTest(GetParam()) {}
  ~DisplayInOrder() override {
    for (const auto& violation : bench.violations("display")) ADD_FAILURE() << violation.rule << violation.message;
  }
};

TEST_P(DisplayInOrder, WithoutADisplayEveryOperationIsAnsweredNoDisplay) {
  call("show_text", {"Hello"});
  call("show_image", {"data:image/png;base64,AAAA"});
  call("ask", {"Go?"});
  call("choose", {"Which?", List{"a", "b"}});
  call("ask_number", {"How many?", 0, 5});
  call("show_progress", {"Working", 0.5});
  call("ask", {"Go?"}, {{"display", "left"}});
  EXPECT_THAT(bench.responses(), ElementsAre("display.show_text !> no_display", "display.show_image !> no_display",
                                             "display.ask !> no_display", "display.choose !> no_display",
                                             "display.ask_number !> no_display", "display.show_progress !> no_display",
                                             "display.ask !> no_display"));
  EXPECT_EQ(complaint(), "display");
  EXPECT_EQ(state(), "Idle");
}

TEST_P(DisplayInOrder, ClearingWhatIsNotThereIsNoFault) {
  call("clear");
  EXPECT_THAT(bench.responses(), ElementsAre("display.clear -> null"));
}

TEST_P(DisplayInOrder, ShowsTextAndImagesAndAnswersAtOnce) {
  connect("main");
  call("show_text", {"Hello"});
  EXPECT_EQ(screens.content("main")->message->text, "Hello");
  call("show_image", {"data:image/png;base64,AAAA", "Look", List{"Seen"}});
  EXPECT_EQ(screens.content("main")->message, (Message{"Look", "data:image/png;base64,AAAA", {"Seen"}}));
  EXPECT_THAT(bench.responses(), ElementsAre("display.show_text -> null", "display.show_image -> null"));
}

TEST_P(DisplayInOrder, AnAskedPersonAnswersWithAButtonLater) {
  connect("main");
  call("ask", {"Go?", List{"Yes", "No"}});
  pass(60);
  EXPECT_THAT(bench.responses(), IsEmpty());
  EXPECT_EQ(state(), "Asking");
  answer("main", "No");
  EXPECT_THAT(bench.responses(), ElementsAre(R"(display.ask -> {"answer":"No","display":"main"})"));
  EXPECT_THAT(events(),
              ElementsAre(R"(connected {"display":"main","place":""})", R"(answer {"answer":"No","display":"main"})"));
  EXPECT_EQ(state(), "Idle");
}

TEST_P(DisplayInOrder, AskHasOneButtonIfNoneIsGiven) {
  connect("main");
  call("ask", {"Collision. Continue?"});
  EXPECT_THAT(screens.content("main")->question->buttons, ElementsAre("OK"));
}

TEST_P(DisplayInOrder, ChooseAnswersTheChoiceAlone) {
  connect("main");
  call("choose", {"What now?", List{"Retry", "Skip"}});
  answer("main", "Skip");
  EXPECT_THAT(bench.responses(), ElementsAre(R"(display.choose -> "Skip")"));
}

TEST_P(DisplayInOrder, ANumberIsEnteredWithinItsLimits) {
  connect("main");
  call("ask_number", {"How wide?", 0.0, 0.11}, {{"unit", "m"}, {"initial", 0.03}});
  EXPECT_EQ(screens.content("main")->question->number, (NumberEntry{"m", 0.0, 0.11, 0.03}));
  answer("main", 0.05);
  EXPECT_THAT(bench.responses(), ElementsAre(R"(display.ask_number -> {"answer":0.05,"display":"main"})"));
}

TEST_P(DisplayInOrder, TheFirstDisplayThatAnswersCounts) {
  connect("left");
  connect("right");
  call("ask", {"Go?", List{"Yes", "No"}});
  answer("right", "Yes");
  EXPECT_FALSE(screens.answer("left", "No"));
  pass(0.01);
  EXPECT_THAT(bench.responses(), ElementsAre(R"(display.ask -> {"answer":"Yes","display":"right"})"));
}

TEST_P(DisplayInOrder, ANamedDisplayAloneShowsAndAnswers) {
  connect("left");
  connect("right");
  call("ask", {"Go?"}, {{"display", "right"}});
  EXPECT_FALSE(screens.content("left")->question);
  EXPECT_FALSE(screens.answer("left", "OK"));
  answer("right", "OK");
  EXPECT_THAT(bench.responses(), ElementsAre(R"(display.ask -> {"answer":"OK","display":"right"})"));
}

TEST_P(DisplayInOrder, ANewQuestionAnswersTheOneBefore) {
  connect("main");
  call("ask", {"First?"});
  call("ask_number", {"Second?", 0, 9});
  EXPECT_THAT(bench.responses(), ElementsAre("display.ask !> replaced"));
  answer("main", 7);
  EXPECT_THAT(bench.responses(),
              ElementsAre("display.ask !> replaced", R"(display.ask_number -> {"answer":7,"display":"main"})"));
}

TEST_P(DisplayInOrder, AnAnswerBeforeTheNextQuestionStillCounts) {
  connect("main");
  call("ask", {"First?"});
  ASSERT_TRUE(screens.answer("main", "OK"));
  call("ask", {"Second?"});
  EXPECT_THAT(bench.responses(), ElementsAre(R"(display.ask -> {"answer":"OK","display":"main"})"));
  EXPECT_EQ(state(), "Asking");
}

TEST_P(DisplayInOrder, AQuestionThatCannotBeShownLeavesTheOneBefore) {
  connect("main");
  call("ask", {"First?"});
  call("ask", {"Second?"}, {{"display", "left"}});
  EXPECT_THAT(bench.responses(), ElementsAre("display.ask !> no_display"));
  answer("main", "OK");
  EXPECT_EQ(bench.responses().back(), R"(display.ask -> {"answer":"OK","display":"main"})");
}

TEST_P(DisplayInOrder, ClearEndsAQuestionThatNoDisplayShowsThen) {
  connect("left");
  connect("right");
  call("ask", {"Go?"});
  call("clear", {"left"});
  EXPECT_THAT(bench.responses(), ElementsAre("display.clear -> null"));
  EXPECT_EQ(state(), "Asking");
  call("clear");
  EXPECT_THAT(bench.responses(),
              ElementsAre("display.clear -> null", "display.ask !> cleared", "display.clear -> null"));
  EXPECT_EQ(state(), "Idle");
  EXPECT_FALSE(screens.content("right")->question);
}

TEST_P(DisplayInOrder, TextsAndImagesCanChangeWhileAQuestionWaits) {
  connect("main");
  call("ask", {"Go?"});
  call("show_text", {"Still there?"});
  call("show_image", {"data:image/png;base64,AAAA"});
  call("show_text", {"Not there"}, {{"display", "left"}});
  call("clear", {"left"});
  EXPECT_THAT(bench.responses(), ElementsAre("display.show_text -> null", "display.show_image -> null",
                                             "display.show_text !> no_display", "display.clear !> no_display"));
  answer("main", "OK");
}

TEST_P(DisplayInOrder, AQuestionWhoseLastDisplayStaysAwayIsLost) {
  connect("left");
  connect("right");
  call("ask", {"Go?"});
  disconnect("left");
  pass(2 * Display::kReconnectTimeout);
  EXPECT_THAT(bench.responses(), IsEmpty());
  disconnect("right");
  pass(Display::kReconnectTimeout - 0.01);
  EXPECT_THAT(bench.responses(), IsEmpty());
  pass(0.02);
  EXPECT_THAT(bench.responses(), ElementsAre("display.ask !> display_lost"));
  EXPECT_EQ(state(), "Idle");
  connect("left");
  EXPECT_FALSE(screens.content("left")->question);
}

TEST_P(DisplayInOrder, ADisplayThatIsBackInTimeStillShowsItsQuestion) {
  connect("main");
  call("ask", {"Go?"});
  for (int i = 0; i < 3; ++i) {
    disconnect("main");
    pass(Display::kReconnectTimeout * 0.9);
    connect("main");
  }
  answer("main", "OK");
  EXPECT_THAT(bench.responses(), ElementsAre(R"(display.ask -> {"answer":"OK","display":"main"})"));
}

TEST_P(DisplayInOrder, EachPressOfAShownButtonIsAnEvent) {
  connect("main");
  call("show_text", {"Moving", List{"Stop"}});
  ASSERT_TRUE(screens.press("main", "Stop"));
  ASSERT_TRUE(screens.press("main", "Stop"));
  pass(0.001);
  const std::string press = R"(button {"button":"Stop","display":"main"})";
  EXPECT_THAT(events(), ElementsAre(R"(connected {"display":"main","place":""})", press, press));
}

TEST_P(DisplayInOrder, TellsWhoComesAndGoes) {
  connect("main");
  disconnect("main");
  EXPECT_THAT(events(), ElementsAre(R"(connected {"display":"main","place":""})",
                                    R"(disconnected {"display":"main","place":""})"));
}

TEST_P(DisplayInOrder, TellsWhereADisplayIs) {
  connect("main", "gripper");
  disconnect("main");
  EXPECT_THAT(events(), ElementsAre(R"(connected {"display":"main","place":"gripper"})",
                                    R"(disconnected {"display":"main","place":"gripper"})"));
}

TEST_P(DisplayInOrder, ReachesWhatIsAtAPlace) {
  connect("left", "gripper");
  connect("right");
  call("show_text", {"There"}, {{"display", "@gripper"}});
  EXPECT_EQ(screens.content("left")->message->text, "There");
  EXPECT_FALSE(screens.content("right")->message);
  call("ask", {"Go?"}, {{"display", "@door"}});
  call("ask", {"Go?"}, {{"display", "@gripper"}});
  answer("left", "OK");
  call("clear", {"@gripper"});
  EXPECT_FALSE(screens.content("left")->message);
  EXPECT_THAT(bench.responses(),
              ElementsAre("display.show_text -> null", "display.ask !> no_display",
                          R"(display.ask -> {"answer":"OK","display":"left"})", "display.clear -> null"));
}

TEST_P(DisplayInOrder, AQuestionAtAPlaceWaitsForItsDisplayToComeBack) {
  connect("main", "gripper");
  call("ask", {"Go?"}, {{"display", "@gripper"}});
  disconnect("main");
  pass(Display::kReconnectTimeout * 0.9);
  connect("main", "gripper");
  answer("main", "OK");
  EXPECT_THAT(bench.responses(), ElementsAre(R"(display.ask -> {"answer":"OK","display":"main"})"));
}

TEST_P(DisplayInOrder, ShowsProgressUntilSomethingElseIsShown) {
  connect("main");
  call("show_progress", {"Calibrating", 0.25});
  EXPECT_EQ(screens.content("main")->message, (Message{"Calibrating", "", {}, 0.25}));
  call("ask", {"Go?"});
  call("show_progress", {"Calibrating", 1});
  EXPECT_EQ(screens.content("main")->message->progress, 1);
  EXPECT_EQ(state(), "Asking");
  answer("main", "OK");
  call("show_text", {"Done"});
  EXPECT_FALSE(screens.content("main")->message->progress);
  call("show_progress", {"Calibrating", 0});
  call("clear");
  EXPECT_FALSE(screens.content("main")->message);
}

INSTANTIATE_TEST_SUITE_P(HereAndElsewhere, DisplayInOrder, testing::Bool());

struct Wrong {
  std::string operation;
  List args;
  Dict kwargs;
  std::string code, argument;
};

/// What a caller does wrong is answered at once and shows nothing; the monitor finds fault with the caller alone.
struct DisplayArguments : DisplayTest, testing::WithParamInterface<std::tuple<bool, Wrong>> {
  DisplayArguments() : DisplayTest(std::get<bool>(GetParam())) {}
};

TEST_P(DisplayArguments, AreHeldToTheirLimits) {
  const Wrong& wrong = std::get<Wrong>(GetParam());
  connect("main");
  for (const bool asking : {false, true}) {
    if (asking) call("ask", {"Go?"});
    const auto before = screens.content("main");
    call(wrong.operation, wrong.args, wrong.kwargs);
    EXPECT_EQ(bench.responses().back(), "display." + wrong.operation + " !> " + wrong.code);
    EXPECT_EQ(complaint(), wrong.argument);
    EXPECT_EQ(screens.content("main"), before);
    EXPECT_EQ(state(), asking ? "Asking" : "Idle");
  }
  for (const auto& violation : bench.violations("display")) EXPECT_EQ(violation.rule, "type") << violation.message;
}

const double kNaN = std::numeric_limits<double>::quiet_NaN();

INSTANTIATE_TEST_SUITE_P(
    Wrong, DisplayArguments,
    testing::Combine(
        testing::Bool(),
        testing::Values(Wrong{"show_text", {}, {}, "missing", "text"}, Wrong{"show_text", {1}, {}, "type", "text"},
                        Wrong{"show_text", {std::string(2001, 'x')}, {}, "too_large", "text"},
                        Wrong{"show_text", {"x"}, {{"display", "a b"}}, "name", "display"},
                        Wrong{"show_text", {"x", List{""}}, {}, "out_of_range", "buttons"},
                        Wrong{"show_text", {"x", List(9, "x")}, {}, "out_of_range", "buttons"},
                        Wrong{"show_text", {"x", List{1}}, {}, "type", "buttons"},
                        Wrong{"show_text", {"x"}, {{"display", "@"}}, "name", "display"},
                        Wrong{"show_text", {"x"}, {{"display", "@main"}}, "no_display", "display"},
                        Wrong{"show_progress", {"x"}, {}, "missing", "progress"},
                        Wrong{"show_progress", {"x", 1.01}, {}, "out_of_range", "progress"},
                        Wrong{"show_progress", {"x", -0.01}, {}, "out_of_range", "progress"},
                        Wrong{"show_progress", {"x", kNaN}, {}, "out_of_range", "progress"},
                        Wrong{"show_progress", {"x", "half"}, {}, "type", "progress"},
                        Wrong{"show_progress", {std::string(2001, 'x'), 0}, {}, "too_large", "text"},
                        Wrong{"show_image", {"scene.json"}, {}, "type", "image"},
                        Wrong{"show_image", {"none.png"}, {}, "not_found", "image"},
                        Wrong{"ask", {"Go?", List{}}, {}, "out_of_range", "buttons"},
                        Wrong{"ask", {"Go?", List{"x", "x"}}, {}, "duplicate", "buttons"},
                        Wrong{"ask", {"Go?", List{std::string(41, 'x')}}, {}, "out_of_range", "buttons"},
                        Wrong{"choose", {"Which?"}, {}, "missing", "choices"},
                        Wrong{"choose", {"Which?", List{}}, {}, "out_of_range", "choices"},
                        Wrong{"ask_number", {"How many?", 0}, {}, "missing", "max"},
                        Wrong{"ask_number", {"How many?", 2, 1}, {}, "out_of_range", "max"},
                        Wrong{"ask_number", {"How many?", kNaN, 1}, {}, "out_of_range", "min"},
                        Wrong{"ask_number", {"How many?", 0, INFINITY}, {}, "out_of_range", "max"},
                        Wrong{"ask_number", {"How many?", 0, 1}, {{"initial", 2}}, "out_of_range", "initial"},
                        Wrong{"ask_number", {"How many?", 0, 1}, {{"initial", kNaN}}, "out_of_range", "initial"},
                        Wrong{"ask_number", {"How many?", 0, 1, std::string(17, 'm')}, {}, "too_large", "unit"},
                        Wrong{"clear", {"nobody"}, {}, "no_display", "display"},
                        Wrong{"clear", {"a/b"}, {}, "name", "display"})));

}  // namespace
}  // namespace race::display
