#include "services/display/screens.h"

#include <gmock/gmock.h>

#include <cmath>

namespace race::display {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Optional;

struct ScreensTest : testing::Test, Watcher {
  ScreensTest() { screens.watch(this); }
  void changed(const Content& content) override { seen.push_back(content); }
  void forgotten(const std::string& display) override { lost.push_back(display); }

  Content content(const std::string& display) { return screens.content(display).value(); }
  std::string question_on(const std::string& display) {
    const auto shown = screens.content(display);
    return shown && shown->question ? shown->question->text : "";
  }
  static Question buttons(std::string text) { return {0, std::move(text), {"Yes", "No"}, {}}; }
  static Question number(double min, double max) { return {0, "How many?", {}, NumberEntry{"", min, max, {}}}; }

  std::vector<Content> seen;
  std::vector<std::string> lost;
  Screens screens;
};

TEST(DisplayName, IsAWordThatIsNotAll) {
  for (const char* name : {"main", "a", "left-2", "Tool_Phone"}) EXPECT_TRUE(is_display_name(name)) << name;
  for (const char* name : {"", "all", "a b", "a/b", "ä", "012345678901234567890123456789012"})
    EXPECT_FALSE(is_display_name(name)) << name;
}

TEST_F(ScreensTest, NothingIsShownWhereNobodyIsConnected) {
  EXPECT_EQ(screens.show("all", {"Hello", "", {}}).error().code, ErrorCode::not_found);
  screens.connect("left", false).value();
  EXPECT_EQ(screens.show("right", {"Hello", "", {}}).error().code, ErrorCode::not_found);
  EXPECT_EQ(screens.ask("right", buttons("Go?")).error().code, ErrorCode::not_found);
  EXPECT_EQ(screens.clear("right").error().code, ErrorCode::not_found);
  EXPECT_THAT(seen, IsEmpty());
}

TEST_F(ScreensTest, AMessageReachesTheDisplaysThatItNames) {
  screens.connect("left", false).value();
  screens.connect("right", false).value();
  ASSERT_TRUE(screens.show("left", {"Left", "", {}}));
  EXPECT_EQ(content("left").message->text, "Left");
  EXPECT_FALSE(content("right").message);
  EXPECT_EQ(seen.size(), 1U);
  ASSERT_TRUE(screens.show("all", {"Both", "", {}}));
  EXPECT_EQ(content("left").message->text, "Both");
  EXPECT_EQ(content("right").message->text, "Both");
}

TEST_F(ScreensTest, ADisplayThatComesLaterShowsWhatAllShow) {
  screens.connect("left", false).value();
  ASSERT_TRUE(screens.show("all", {"Both", "", {}}));
  ASSERT_TRUE(screens.ask("all", buttons("Go?")));
  screens.connect("late", false).value();
  EXPECT_EQ(content("late").message->text, "Both");
  EXPECT_EQ(question_on("late"), "Go?");
}

TEST_F(ScreensTest, ADisplayThatComesBackShowsWhatItShowed) {
  const auto id = screens.connect("left", false).value();
  ASSERT_TRUE(screens.show("left", {"Left", "", {}}));
  screens.disconnect(id);
  EXPECT_THAT(screens.connected(), IsEmpty());
  screens.connect("left", false).value();
  EXPECT_EQ(content("left").message->text, "Left");
}

TEST_F(ScreensTest, TheFirstAnswerCountsAndTakesTheQuestionAway) {
  screens.connect("left", false).value();
  screens.connect("right", false).value();
  const auto question = screens.ask("all", buttons("Go?")).value();
  screens.take();
  ASSERT_TRUE(screens.answer("right", "No", question));
  EXPECT_EQ(screens.answer("left", "Yes", question).error().code, ErrorCode::conflict);
  EXPECT_THAT(screens.take(), ElementsAre(DisplayEvent{DisplayEvent::Kind::answered, "right", "No", question}));
  EXPECT_EQ(question_on("left"), "");
  EXPECT_FALSE(screens.asking());
}

TEST_F(ScreensTest, AnAnswerToAnEarlierQuestionDoesNotAnswerTheNextOne) {
  screens.connect("left", false).value();
  const auto earlier = screens.ask("all", buttons("Go?")).value();
  screens.ask("all", buttons("Really?")).value();
  EXPECT_EQ(screens.answer("left", "Yes", earlier).error().code, ErrorCode::conflict);
  EXPECT_EQ(question_on("left"), "Really?");
}

TEST_F(ScreensTest, AnAnswerIsOneOfTheButtons) {
  screens.connect("left", false).value();
  screens.ask("all", buttons("Go?")).value();
  EXPECT_EQ(screens.answer("left", "Maybe").error().code, ErrorCode::type);
  EXPECT_EQ(screens.answer("left", 1).error().code, ErrorCode::type);
  EXPECT_EQ(screens.answer("nobody", "Yes").error().code, ErrorCode::not_found);
  EXPECT_TRUE(screens.answer("left", "Yes"));
}

TEST_F(ScreensTest, ANumberIsFiniteAndWithinItsLimits) {
  screens.connect("left", false).value();
  const auto question = screens.ask("all", number(-1, 4)).value();
  for (const Value& wrong : {Value(4.5), Value(-2), Value(std::nan("")), Value(INFINITY)})
    EXPECT_EQ(screens.answer("left", wrong).error().code, ErrorCode::out_of_range);
  EXPECT_EQ(screens.answer("left", "2").error().code, ErrorCode::type);
  screens.take();
  ASSERT_TRUE(screens.answer("left", 4));
  EXPECT_THAT(screens.take(), ElementsAre(DisplayEvent{DisplayEvent::Kind::answered, "left", 4, question}));
}

TEST_F(ScreensTest, OnlyButtonsThatAreShownCanBePressed) {
  screens.connect("left", false).value();
  screens.take();
  ASSERT_TRUE(screens.show("left", {"Moving", "", {"Stop"}}));
  EXPECT_EQ(screens.press("left", "Go").error().code, ErrorCode::conflict);
  EXPECT_TRUE(screens.press("left", "Stop"));
  EXPECT_TRUE(screens.press("left", "Stop"));
  EXPECT_EQ(screens.take().size(), 2U);
}

TEST_F(ScreensTest, AQuestionIsThereWhileADisplayThatShowsItIsConnected) {
  const auto left = screens.connect("left", false).value();
  const auto right = screens.connect("right", false).value();
  screens.ask("all", buttons("Go?")).value();
  screens.disconnect(left);
  EXPECT_TRUE(screens.asking());
  screens.disconnect(right);
  EXPECT_FALSE(screens.asking());
  screens.connect("right", false).value();
  EXPECT_TRUE(screens.asking());
}

TEST_F(ScreensTest, ClearingTheLastDisplayThatShowsAQuestionEndsIt) {
  screens.connect("left", false).value();
  screens.connect("right", false).value();
  screens.ask("all", buttons("Go?")).value();
  EXPECT_FALSE(screens.clear("left").value());
  EXPECT_EQ(question_on("left"), "");
  EXPECT_EQ(question_on("right"), "Go?");
  EXPECT_TRUE(screens.clear("right").value());
  EXPECT_FALSE(screens.clear("all").value());
}

TEST_F(ScreensTest, TwoConnectionsOfOneNameAreOneDisplay) {
  const auto first = screens.connect("left", false).value();
  screens.connect("left", false).value();
  screens.disconnect(first);
  EXPECT_THAT(screens.connected(), ElementsAre("left"));
  EXPECT_THAT(screens.take(), ElementsAre(DisplayEvent{DisplayEvent::Kind::connected, "left", {}, 0}));
}

TEST_F(ScreensTest, ASoundGoesToThoseWhoMayMakeSounds) {
  screens.connect("mute", false).value();
  EXPECT_EQ(screens.play("all", {0, "beep", 1, 1}).error().code, ErrorCode::not_found);
  const auto loud = screens.connect("loud", true).value();
  const auto sound = screens.play("all", {0, "beep", 1, 1}).value();
  EXPECT_EQ(screens.playback().waiting, 1U);
  EXPECT_EQ(screens.played(loud, sound + 1).error().code, ErrorCode::conflict);
  EXPECT_TRUE(screens.played(loud, sound));
  EXPECT_EQ(screens.played(loud, sound).error().code, ErrorCode::conflict);
  EXPECT_EQ(screens.playback().waiting, 0U);
  EXPECT_THAT(screens.playback().reported, ElementsAre("loud"));
  screens.silence();
  EXPECT_FALSE(content("loud").sound);
}

TEST_F(ScreensTest, ASpeakerThatGoesIsNotWaitedFor) {
  const auto loud = screens.connect("loud", true).value();
  screens.play("loud", {0, "beep", 1, 1}).value();
  screens.disconnect(loud);
  EXPECT_EQ(screens.playback().waiting, 0U);
  EXPECT_THAT(screens.playback().reported, IsEmpty());
}

TEST_F(ScreensTest, RepeatTellsWhatIsShownNow) {
  screens.connect("left", false).value();
  screens.repeat("left");
  screens.repeat("nobody");
  EXPECT_THAT(seen, ElementsAre(Content{"left", {}, {}, {}}));
}

TEST_F(ScreensTest, NamesAreBoundedAndThoseWithoutConnectionMakeWay) {
  for (std::size_t i = 0; i < Screens::kDisplays; ++i) screens.connect("d" + std::to_string(i), false).value();
  EXPECT_EQ(screens.connect("one-more", false).error().code, ErrorCode::conflict);
  EXPECT_TRUE(screens.connect("d0", false));
  const auto gone = screens.content("d7");
  ASSERT_TRUE(gone);
  screens.disconnect(8);  // connections count from 1
  EXPECT_TRUE(screens.connect("one-more", false));
  EXPECT_THAT(lost, ElementsAre("d7"));
  EXPECT_FALSE(screens.content("d7"));
}

// ---- Places.

TEST(DisplayTarget, IsANameAPlaceOrAll) {
  for (const char* target : {"all", "main", "@gripper", "@left-2"}) EXPECT_TRUE(is_display_target(target)) << target;
  for (const char* target :
       {"", "@", "@all", "@@gripper", "@a b", "main@gripper", "@012345678901234567890123456789012"})
    EXPECT_FALSE(is_display_target(target)) << target;
}

TEST_F(ScreensTest, APlaceIsNamedAsADisplayIs) {
  for (const char* wrong : {"all", "@gripper", "a/b", "012345678901234567890123456789012"}) {
    const auto refused = screens.connect("left", false, wrong);
    ASSERT_FALSE(refused) << wrong;
    EXPECT_EQ(refused.error().code, ErrorCode::name);
    EXPECT_EQ(refused.error().path, "place");
  }
  EXPECT_THAT(screens.connected(), IsEmpty());
}

TEST_F(ScreensTest, APlaceReachesAllDisplaysThereAndNoOthers) {
  screens.connect("left", false, "gripper").value();
  screens.connect("right", false, "gripper").value();
  screens.connect("gripper", false).value();
  screens.connect("door", false, "door").value();
  ASSERT_TRUE(screens.show("@gripper", {"There", "", {}}));
  EXPECT_EQ(seen.size(), 5U) << "three came to their place, and two show something";
  EXPECT_EQ(content("left").message->text, "There");
  EXPECT_EQ(content("right").message->text, "There");
  EXPECT_FALSE(content("gripper").message) << "a name is no place";
  EXPECT_FALSE(content("door").message);
  ASSERT_TRUE(screens.ask("@door", buttons("Go?")));
  EXPECT_EQ(question_on("door"), "Go?");
  EXPECT_EQ(question_on("left"), "");
  EXPECT_FALSE(screens.answer("left", "Yes"));
  EXPECT_TRUE(screens.answer("door", "Yes"));
}

TEST_F(ScreensTest, NothingIsShownAtAPlaceWhereNobodyIs) {
  const auto id = screens.connect("left", false, "gripper").value();
  EXPECT_EQ(screens.show("@door", {"Hello", "", {}}).error().code, ErrorCode::not_found);
  EXPECT_EQ(screens.show("@left", {"Hello", "", {}}).error().code, ErrorCode::not_found);
  EXPECT_EQ(screens.clear("@door").error().code, ErrorCode::not_found);
  screens.disconnect(id);
  EXPECT_EQ(screens.show("@gripper", {"Hello", "", {}}).error().code, ErrorCode::not_found);
  EXPECT_EQ(screens.ask("@gripper", buttons("Go?")).error().code, ErrorCode::not_found);
  EXPECT_TRUE(screens.clear("@gripper")) << "as with a display that has left";
}

TEST_F(ScreensTest, WhereNobodyIsTheMessageSaysWhoIsAndWhatToDo) {
  const auto said = [this](const char* target) { return screens.show(target, {"Hello", "", {}}).error().message; };
  EXPECT_EQ(said("all"), "no display is connected: open /display/ on one");
  EXPECT_EQ(said("right"), "no display named `right` is connected: open /display/?name=right");
  screens.connect("left", false, "gripper").value();
  screens.connect("middle", false, "gripper").value();
  EXPECT_EQ(said("right"),
            "no display named `right` is connected: open /display/?name=right, or write one that is: `left`, `middle`");
  EXPECT_EQ(
      said("@door"),
      "no display at the place `door` is connected: open /display/?place=door on the one there, or write one that "
      "is: `@gripper`");
  for (int i = 0; i < 20; ++i) screens.connect("d" + std::to_string(i), false).value();
  EXPECT_THAT(said("right"), testing::EndsWith("`d14`, `d15`, `d16`, and more"));
}

TEST_F(ScreensTest, ADisplayThatComesToAPlaceLaterShowsWhatIsShownThere) {
  screens.connect("left", false, "gripper").value();
  ASSERT_TRUE(screens.show("@gripper", {"There", "", {}}));
  ASSERT_TRUE(screens.ask("@gripper", buttons("Go?")));
  screens.connect("late", false, "gripper").value();
  EXPECT_EQ(content("late").message->text, "There");
  EXPECT_EQ(question_on("late"), "Go?");
  screens.connect("elsewhere", false).value();
  EXPECT_FALSE(content("elsewhere").message);
  EXPECT_EQ(question_on("elsewhere"), "");
}

TEST_F(ScreensTest, WhatWasShownLastIsWhatADisplayShowsThatComes) {
  const auto left = screens.connect("left", false, "gripper").value();
  ASSERT_TRUE(screens.show("@gripper", {"There", "", {}}));
  ASSERT_TRUE(screens.show("all", {"Everywhere", "", {}}));
  screens.connect("late", false, "gripper").value();
  EXPECT_EQ(content("late").message->text, "Everywhere");
  ASSERT_TRUE(screens.show("@gripper", {"There again", "", {}}));
  ASSERT_TRUE(screens.show("left", {"Left", "", {}}));
  screens.disconnect(left);
  screens.connect("left", false, "gripper").value();
  EXPECT_EQ(content("left").message->text, "Left");
  ASSERT_TRUE(screens.clear("@gripper").has_value());
  screens.connect("later", false, "gripper").value();
  EXPECT_FALSE(content("later").message) << "and not what all show";
}

TEST_F(ScreensTest, WhatIsClearedAtAPlaceIsClearedForWhoComesLater) {
  screens.connect("left", false, "gripper").value();
  screens.connect("door", false).value();
  ASSERT_TRUE(screens.ask("all", buttons("Go?")));
  EXPECT_FALSE(screens.clear("@gripper").value()) << "the other one shows it";
  screens.connect("late", false, "gripper").value();
  EXPECT_EQ(question_on("late"), "");
  ASSERT_TRUE(screens.ask("all", buttons("Again?")));
  screens.connect("later", false, "gripper").value();
  EXPECT_EQ(question_on("later"), "Again?");
  ASSERT_TRUE(screens.clear("all").value());
  ASSERT_TRUE(screens.ask("all", buttons("And again?")));
  screens.connect("last", false).value();
  EXPECT_EQ(question_on("last"), "And again?");
}

TEST_F(ScreensTest, ADisplayIsWhereItsNewestConnectionSaysThatNamesAPlace) {
  const auto first = screens.connect("left", false, "gripper").value();
  const auto second = screens.connect("left", true, "door").value();
  screens.connect("left", false).value();
  screens.connect("other", false, "gripper").value();
  screens.connect("third", false, "door").value();
  screens.take();
  ASSERT_TRUE(screens.show("@door", {"Door", "", {}}));
  EXPECT_EQ(content("left").message->text, "Door");
  screens.disconnect(second);
  ASSERT_TRUE(screens.show("@gripper", {"Gripper", "", {}}));
  EXPECT_EQ(content("left").message->text, "Gripper");
  screens.disconnect(first);
  ASSERT_TRUE(screens.show("@gripper", {"Still", "", {}}));
  EXPECT_EQ(content("left").message->text, "Gripper") << "it is nowhere in particular now";
  using enum DisplayEvent::Kind;
  EXPECT_THAT(screens.take(), ElementsAre(DisplayEvent{connected, "left", {}, 0, "gripper"},
                                          DisplayEvent{connected, "left", {}, 0, ""}));
}

TEST_F(ScreensTest, ItIsToldWhereADisplayIsThatComesMovesAndGoes) {
  const auto first = screens.connect("left", false).value();
  const auto second = screens.connect("left", false, "gripper").value();
  screens.disconnect(first);
  screens.disconnect(second);
  using enum DisplayEvent::Kind;
  EXPECT_THAT(screens.take(),
              ElementsAre(DisplayEvent{connected, "left", {}, 0, ""}, DisplayEvent{connected, "left", {}, 0, "gripper"},
                          DisplayEvent{disconnected, "left", {}, 0, "gripper"}));
}

TEST_F(ScreensTest, ADisplayThatMovesIsToldWhatItShowsThere) {
  screens.connect("left", false, "gripper").value();
  ASSERT_TRUE(screens.show("@gripper", {"There", "", {}}));
  const auto door = screens.connect("right", false).value();
  seen.clear();
  screens.connect("right", false, "gripper").value();
  screens.disconnect(door);
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_EQ(seen[0].message->text, "There");
}

TEST_F(ScreensTest, ASoundAtAPlaceIsPlayedThereAlone) {
  screens.connect("left", true, "gripper").value();
  screens.connect("right", true).value();
  EXPECT_EQ(screens.play("@door", {0, "beep", 1, 1}).error().code, ErrorCode::not_found);
  ASSERT_TRUE(screens.play("@gripper", {0, "beep", 1, 1}));
  EXPECT_TRUE(content("left").sound);
  EXPECT_FALSE(content("right").sound);
  EXPECT_EQ(screens.playback().waiting, 1U);
}

TEST_F(ScreensTest, PlacesAreBoundedAndThoseWithoutADisplayMakeWay) {
  screens.connect("stays", false, "first").value();
  ASSERT_TRUE(screens.show("@first", {"First", "", {}}));
  for (std::size_t i = 0; i < Screens::kDisplays; ++i) {
    const std::string place = "p" + std::to_string(i);
    const auto id = screens.connect("moves", false, place).value();
    ASSERT_TRUE(screens.show('@' + place, {place, "", {}}));
    screens.disconnect(id);
  }
  for (const char* place : {"p0", "p1", "first"}) screens.connect(std::string("at-") + place, false, place).value();
  EXPECT_FALSE(content("at-p0").message) << "the oldest where nobody is";
  EXPECT_EQ(content("at-p1").message->text, "p1");
  EXPECT_EQ(content("at-first").message->text, "First") << "older, but somebody is there";
}

TEST_F(ScreensTest, WhatWaitsForTheServiceIsBounded) {
  screens.connect("left", false).value();
  ASSERT_TRUE(screens.show("left", {"", "", {"Stop"}}));
  screens.take();
  for (std::size_t i = 0; i < Screens::kMaxPendingEvents; ++i) ASSERT_TRUE(screens.press("left", "Stop"));
  EXPECT_EQ(screens.press("left", "Stop").error().code, ErrorCode::conflict);
  EXPECT_EQ(screens.take().size(), Screens::kMaxPendingEvents);
  EXPECT_TRUE(screens.press("left", "Stop"));
}

}  // namespace
}  // namespace race::display
