// The scenarios of thesis chapter 5.2, 5.3 and appendix B: the derivation of each macro step, micro step by micro step,
// as the thesis writes it. A line is "macro-micro: rules", in order of application; the models are those of
// tests/conformance.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "core/execution/derive.h"

namespace race::semantics {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::string read(const std::string& scenario, const std::string& file) {
  std::ifstream in(std::string(RACE_SOURCE_DIR) + "/tests/conformance/" + scenario + "/" + file);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

std::string last_part(const std::string& path) { return path.substr(path.rfind('/') + 1); }

// The rules of the activation and micro layer, executed actions and functions; what they are about by its name.
void collect(const Value& node, std::vector<std::string>& out) {
  const std::string& rule = node.find("rule")->as_string();
  std::string text = rule + " " + last_part(node.find("at")->as_string());
  if (rule == "PTrigger") text += "." + node.find("port")->as_string();
  if (rule == "Action1") text += "#" + std::to_string(node.find("action")->as_integer());
  if (rule == "Func") text += " " + node.find("of")->as_string();
  static const char* const kShown[] = {"PTrigger", "PTrans1", "PTrans2", "SProp", "SAct1",  "SAct2",   "SDeact1",
                                       "SDeact2",  "BAct1",   "BAct2",   "BAct3", "BDeact", "Action1", "Func"};
  if (std::ranges::find(kShown, rule) != std::end(kShown)) out.push_back(text);
  for (const Value& premise : node.find("premises")->as_list()) collect(premise, out);
}

struct Derived {
  std::vector<std::string> micro;                // "1-1: SAct1 P, SAct1 A"
  std::vector<std::vector<std::string>> active;  // after each macro step, by name
  Value document;
};

Derived derive(const std::string& scenario) {
  auto document = execution::derive_texts(read(scenario, "model.json"), read(scenario, "script.json"));
  EXPECT_TRUE(document);
  Derived out;
  out.document = *document;
  int macro = 0;
  for (const Value& step : document->find("steps")->as_list()) {
    ++macro;
    int micro = 0;
    for (const Value& tree : step.find("micro")->as_list()) {
      std::vector<std::string> rules;
      collect(tree, rules);
      std::string line = std::to_string(macro) + "-" + std::to_string(++micro) + ":";
      for (const std::string& rule : rules) line += (&rule == &rules.front() ? " " : ", ") + rule;
      out.micro.push_back(line);
    }
    out.active.emplace_back();
    for (const Value& path : step.find("state")->find("active")->as_list())
      out.active.back().push_back(last_part(path.as_string()));
  }
  return out;
}

const Value& result(const Derived& d, std::size_t step, const char* state, const char* name) {
  return *d.document.find("steps")->as_list()[step].find("state")->find("results")->find(state)->find(name);
}

// 5.2 "Action execution on state preemption": the second event raises the sum to 16, only then the port preempts.
TEST(ActionExecutionOnStatePreemption, TheActionIsExecutedCompletelyBeforeThePortActivates) {
  const Derived d = derive("scenario-action-on-preemption");
  EXPECT_THAT(d.micro,
              ElementsAre("1-1: SAct1 SumTestData",                                                  //
                          "2-1: SProp SumTestData, Action1 SumTestData#0, Func SumTestData action",  //
                          "3-1: SProp SumTestData, Action1 SumTestData#0, Func SumTestData action",  //
                          "3-2: PTrigger SumTestData.max_reached, SDeact2 SumTestData, Func SumTestData exit"));
  EXPECT_EQ(result(d, 1, "SumTestData", "sum"), Value(8));
  EXPECT_EQ(result(d, 2, "SumTestData", "sum"), Value(16));
}

// 5.2 "Transitions on state preemption": PTrigger of the parent has precedence over PTrans1.
TEST(TransitionsOnStatePreemption, TheParentsPortPreemptsTheTransitionOfTheChild) {
  const Derived d = derive("scenario-transition-on-preemption");
  EXPECT_THAT(d.micro, ElementsAre("1-1: SAct1 Parent, SAct1 A",                   //
                                   "2-1: SProp Parent, PTrigger A.pA, SDeact2 A",  //
                                   "2-2: PTrigger Parent.pP, SDeact2 Parent, SDeact1 A, SDeact1 B"));
  EXPECT_THAT(d.active.back(), IsEmpty());
}

// Appendix B "Action execution sequence": the action on pA, then the entry of B, then the action on B.
TEST(ActionExecutionSequence, TheActionOnAPortPrecedesTheEntryOfItsDestination) {
  const Derived d = derive("scenario-action-sequence");
  EXPECT_THAT(d.micro, ElementsAre("1-1: SAct1 P, SAct1 A",                                              //
                                   "2-1: SProp P, PTrigger A.pA, SDeact2 A, Func A exit",                //
                                   "2-2: PTrans1 P, Action1 P#0, Func P action, SAct1 B, Func B entry",  //
                                   "2-3: SProp P, Action1 P#1, Func P action, SProp B"));
}

// 5.2 and appendix B "Concurrent port activation (same destination)".
TEST(ConcurrentPortActivationSameDestination, TheDestinationIsEnteredOnce) {
  const Derived d = derive("scenario-same-destination");
  EXPECT_THAT(d.micro, ElementsAre("1-1: SAct1 P, BAct1 b",                                             //
                                   "1-2: PTrans2 P, SAct1 A, SAct1 B, BDeact b",                        //
                                   "2-1: SProp P, PTrigger A.pA, SDeact2 A, PTrigger B.pB, SDeact2 B",  //
                                   "2-2: PTrans1 P, SAct1 C, SAct2 C",                                  //
                                   "3-1: SProp P, PTrigger C.pC, SDeact2 C",                            //
                                   "3-2: PTrans1 P, SAct1 D"));
  EXPECT_THAT(d.active.back(), ElementsAre("P", "D"));
}

// 5.2 and appendix B "Concurrent port activation (different destinations)": D is entered before pP preempts.
TEST(ConcurrentPortActivationDifferentDestinations, BothAreEnteredBeforeTheParentPreempts) {
  const Derived d = derive("scenario-different-destinations");
  EXPECT_THAT(d.micro,
              ElementsAre("1-1: SAct1 P, BAct1 b",                                             //
                          "1-2: PTrans2 P, SAct1 A, SAct1 B, BDeact b",                        //
                          "2-1: SProp P, PTrigger A.pA, SDeact2 A, PTrigger B.pB, SDeact2 B",  //
                          "2-2: PTrans1 P, SAct1 C, SAct1 D, Func D entry",                    //
                          "2-3: PTrigger P.pP, SDeact2 P, BDeact b, SDeact1 A, SDeact1 B, SDeact2 C, SDeact2 D"));
  EXPECT_EQ(result(d, 1, "P/D", "entered"), Value(true));
}

// 5.3 "Deadlock and Reachability": the response is deferred to a call that nobody makes.
TEST(Deadlock, BIsNotReachableWhileNobodyResolvesTheDeferredCall) {
  const Derived d = derive("scenario-deadlock");
  EXPECT_THAT(d.micro, ElementsAre("1-1: SAct1 Root, SAct1 A, Func A entry"));
  for (const auto& active : d.active) EXPECT_THAT(active, ElementsAre("Root", "A"));
}

// 5.3, the counterpart: another state calls reset, which resolves the deferred call.
TEST(Reachability, BIsReachedWhenAnotherStateResolvesTheDeferredCall) {
  const Derived d = derive("scenario-reachable");
  EXPECT_THAT(d.micro, ElementsAre("1-1: SAct1 Root, BAct1 b",                                                   //
                                   "1-2: PTrans2 Root, SAct1 A, Func A entry, SAct1 Watch, BDeact b",            //
                                   "3-1: SProp Root, SProp A, SProp Watch, Action1 Watch#0, Func Watch action",  //
                                   "4-1: SProp Root, PTrigger A.success, SDeact2 A, SProp Watch",                //
                                   "4-2: PTrans1 Root, SAct1 B"));
  EXPECT_THAT(d.active.back(), ElementsAre("Root", "Watch", "B"));
}

}  // namespace
}  // namespace race::semantics
