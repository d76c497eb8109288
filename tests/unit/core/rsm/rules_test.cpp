// The rules of RSM on the robot service of Fig. 4.1.
#include "core/rsm/rules.h"

#include <gtest/gtest.h>

#include "tests/unit/core/rsm/robot.h"

namespace race::rsm {
namespace {

using Answers = std::vector<Answer>;
using Events = std::vector<std::string>;

class Robot : public testing::Test {
 protected:
  const Service robot = read_robot();
  Instance instance = initial(robot);

  std::vector<std::string> resolved(std::string_view id) {
    std::vector<std::string> out;
    for (const Transition* t : resolve(robot, *find_transition(robot, id))) out.push_back(t->id);
    return out;
  }
};

using Resolve = Robot;
using Trans1Rule = Robot;
using Trans2Rule = Robot;
using StutterRule = Robot;

TEST_F(Resolve, HoldsItselfWhereNothingIsDeferred) { EXPECT_EQ(resolved("change"), Events{"change"}); }

TEST_F(Resolve, LeavesItselfOutWhereItDefers) { EXPECT_EQ(resolved("start"), Events{}); }

TEST_F(Resolve, HoldsTheTransitionsThatDeferToIt) {
  EXPECT_EQ(resolved("arrive"), (Events{"start", "again", "arrive"}));
}

TEST_F(Resolve, HoldsAllWithoutASource) {
  EXPECT_EQ(resolved("stop"), (Events{"start", "again", "arrive", "change", "stop"}));
}

TEST_F(Trans1Rule, AnswersAtOnceWhereNothingIsDeferred) {
  const auto effect = Trans1(robot, instance, "change_behavior", 7);
  ASSERT_TRUE(effect);
  EXPECT_EQ(effect->answers, (Answers{{7, false, "", "change_behavior"}}));
  EXPECT_EQ(instance, initial(robot));
}

TEST_F(Trans1Rule, DefersTheResponseAndPutsTheEvents) {
  const auto effect = Trans1(robot, instance, "move", 1);
  ASSERT_TRUE(effect);
  EXPECT_EQ(effect->answers, Answers{});
  EXPECT_EQ(effect->events, Events{"started"});
  EXPECT_EQ(instance, (Instance{"Moving", {{"start", {1}}}}));
}

TEST_F(Trans1Rule, DoesNotApplyWhereNoTransitionTakesTheCall) {
  Trans1(robot, instance, "move", 1);
  const Instance before = instance;
  EXPECT_FALSE(Trans1(robot, instance, "change_behavior", 2));
  EXPECT_FALSE(Trans1(robot, instance, "fly", 3));
  EXPECT_EQ(instance, before);
}

TEST_F(Trans1Rule, TakesTheFirstTransitionInOrderOfDeclaration) {
  Service two = robot;
  two.transitions.push_back({"late", "Idle", "Moving", "change_behavior", {}, {}, {}});
  EXPECT_TRUE(Trans1(two, instance, "change_behavior", 1));
  EXPECT_EQ(instance.current, "Idle");
}

TEST_F(Trans1Rule, WithoutASourceAnswersAllThatIsDeferredWithItsErrorAndItselfWithAResult) {
  Trans1(robot, instance, "move", 1);
  const auto effect = Trans1(robot, instance, "stop", 2);
  ASSERT_TRUE(effect);
  EXPECT_EQ(effect->answers, (Answers{{1, true, "aborted", "move"}, {2, false, "", "stop"}}));
  EXPECT_EQ(instance, initial(robot));
}

TEST_F(Trans2Rule, AnswersWhatIsDeferredToIt) {
  Trans1(robot, instance, "move", 1);
  const auto effect = Trans2(robot, instance, "arrive");
  ASSERT_TRUE(effect);
  EXPECT_EQ(effect->answers, (Answers{{1, false, "", "move"}}));
  EXPECT_EQ(instance, initial(robot));
}

TEST_F(Trans2Rule, AnswersTheLatestCallThatTookATransition) {  // R17
  Trans1(robot, instance, "move", 1);
  Trans1(robot, instance, "move", 2);
  Trans1(robot, instance, "move", 3);
  const auto effect = Trans2(robot, instance, "arrive");
  ASSERT_TRUE(effect);
  EXPECT_EQ(effect->answers, (Answers{{1, false, "", "move"}, {3, false, "", "move"}}));
}

// R25
class ConcurrentRule : public Robot {
 protected:
  ConcurrentRule() {
    for (Transition& t : many.transitions) t.concurrent = t.operation == "move";
    for (std::uint64_t call : {1, 2, 3}) Trans1(many, instance, "move", call);
  }
  Service many = robot;
};

TEST_F(ConcurrentRule, AnswersTheCallThatItNamesOfEachThatTookATransition) {
  EXPECT_EQ(instance.pending, (std::map<std::string, std::vector<std::uint64_t>>{{"again", {2, 3}}, {"start", {1}}}));
  EXPECT_EQ(Trans2(many, instance, "arrive", 3)->answers, (Answers{{3, false, "", "move"}}));
  instance.current = "Moving";
  EXPECT_FALSE(Trans2(many, instance, "arrive", 3)) << "it has its response";
  for (std::uint64_t earliest : {1, 2}) {
    instance.current = "Moving";
    EXPECT_EQ(Trans2(many, instance, "arrive")->answers, (Answers{{earliest, false, "", "move"}}));
  }
  EXPECT_TRUE(instance.pending.empty());
}

TEST_F(ConcurrentRule, AnswersAllWithoutASource) {
  EXPECT_EQ(Trans1(many, instance, "stop", 4)->answers, (Answers{{1, true, "aborted", "move"},
                                                                 {2, true, "aborted", "move"},
                                                                 {3, true, "aborted", "move"},
                                                                 {4, false, "", "stop"}}));
}

TEST_F(Trans2Rule, DoesNotApplyFromAnotherStateOrToACall) {
  EXPECT_FALSE(Trans2(robot, instance, "arrive"));
  EXPECT_FALSE(Trans2(robot, instance, "change"));
  EXPECT_FALSE(Trans2(robot, instance, "nothing"));
  EXPECT_EQ(instance, initial(robot));
}

TEST_F(StutterRule, PutsTheEventsOfTheCurrentStateOnly) {
  EXPECT_EQ(Stutter(robot, instance).events, Events{"robot_state"});
  Trans1(robot, instance, "move", 1);
  EXPECT_EQ(Stutter(robot, instance), Effect{});
}

}  // namespace
}  // namespace race::rsm
