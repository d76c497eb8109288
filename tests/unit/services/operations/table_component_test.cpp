#include "services/table_component.h"

#include <gmock/gmock.h>

#include "services/types.h"

namespace race::services {
namespace {

using testing::ElementsAre;

/// Writes down what a component announces.
struct Recorder final : ServiceHost {
  Time now() const override { return 0; }
  void transition(std::string_view id, CallId call) override { note("transition " + std::string(id), call); }
  void result(CallId call, Value) override { note("result", call); }
  void error(CallId call, Value error) override {
    note("error " + error.find("code")->as_string() + (error.find("argument") ? " argument" : ""), call);
  }
  void reject(CallId call) override { note("reject", call); }
  void event(std::string_view, Value) override {}
  void log(std::string) override {}
  void note(const std::string& what, CallId call) { announced.push_back(what + " " + std::to_string(call)); }

  std::vector<std::string> announced;
};

/// A lift: `raise` is deferred, `lower` is accepted above alone, `swap` takes the place of a raise, `beep` ignores what
/// it is given.
class Lift final : public TableComponent {
 public:
  explicit Lift(ServiceHost& host) : TableComponent(operations(), host) {}

  static const OperationTable& operations() {
    static const OperationTable table({
        .name = "lift",
        .operations = {{.name = "raise",
                        .handler = &Lift::raise,
                        .parameters = {{.name = "height", .type = "number", .min = 0, .max = 2}}},
                       {.name = "lower", .handler = &Lift::lower},
                       {.name = "swap",
                        .handler = &Lift::swap,
                        .parameters = {{.name = "height", .type = "number"}},
                        .acceptance = Acceptance::by_handler},
                       {.name = "beep", .handler = &Lift::beep}},
        .states = {{"Below", {}}, {"Rising", {}}, {"Above", {}}},
        .init = "Below",
        .transitions = {{.id = "raise",
                         .src = "Below",
                         .dst = "Rising",
                         .operation = "raise",
                         .defer = {"risen", "refused", "replaced"},
                         .refused = "refused"},
                        {.id = "risen", .src = "Rising", .dst = "Above"},
                        {.id = "refused", .src = "Rising", .dst = "Below"},
                        {.id = "replaced", .src = "Rising", .dst = "Below", .error = "replaced"},
                        {.id = "swap", .src = "Below", .dst = "Above", .operation = "swap"},
                        {.id = "refuse_swap", .src = "Rising", .dst = "Rising", .operation = "swap"},
                        {.id = "lower", .src = "Above", .dst = "Below", .operation = "lower"},
                        {.id = "beep_below", .src = "Below", .dst = "Below", .operation = "beep"},
                        {.id = "beep_above", .src = "Above", .dst = "Above", .operation = "beep"}},
    });
    return table;
  }

  void arrive() {
    take("risen");
    host().result(raising_, nullptr);
  }

 private:
  void raise(const Call& call, const Dict& arguments) {
    if (arguments.find("height")->to_double() == 0) return refuse(call, error_value("no_way", "it is there already"));
    raising_ = call.id;
  }
  void lower(const Call& call) { host().result(call.id, nullptr); }
  void beep(const Call& call) { host().result(call.id, nullptr); }
  void swap(const Call& call, const Dict&) {
    if (raising_ != 0) {
      take("replaced");
      host().error(raising_, error_value("replaced", "another took its place"));
    }
    accept(call);
    host().result(call.id, nullptr);
  }

  CallId raising_ = 0;
};

struct TableComponentTest : testing::Test {
  std::vector<std::string> call(const std::string& operation, List args = {}) {
    recorder.announced.clear();
    lift.call({++calls, operation, std::move(args), {}});
    return recorder.announced;
  }
  Recorder recorder;
  Lift lift{recorder};
  CallId calls = 0;
};

TEST_F(TableComponentTest, TakesTheTransitionOfThePresentStateAndFollowsIt) {
  EXPECT_THAT(call("beep"), ElementsAre("transition beep_below 1", "result 1"));
  EXPECT_THAT(call("raise", {1.5}), ElementsAre("transition raise 2"));
  recorder.announced.clear();
  lift.arrive();
  EXPECT_THAT(recorder.announced, ElementsAre("transition risen 0", "result 2"));
  EXPECT_THAT(call("beep"), ElementsAre("transition beep_above 3", "result 3"));
  EXPECT_THAT(call("lower"), ElementsAre("transition lower 4", "result 4"));
}

TEST_F(TableComponentTest, RejectsWhatTheStateDoesNotAccept) {
  EXPECT_THAT(call("lower"), ElementsAre("reject 1"));
  EXPECT_THAT(call("fly"), ElementsAre("reject 2"));
  call("raise", {1});
  EXPECT_THAT(call("beep"), ElementsAre("reject 4"));
}

TEST_F(TableComponentTest, RejectsBeforeItLooksAtArguments) {
  call("raise", {1});
  EXPECT_THAT(call("raise", {"high"}), ElementsAre("reject 2"));
}

TEST_F(TableComponentTest, AnswersAWrongArgumentAfterTheTransitionAndEndsTheCallByItsRefusal) {
  EXPECT_THAT(call("raise", {"high"}),
              ElementsAre("transition raise 1", "transition refused 0", "error type argument 1"));
  EXPECT_THAT(call("raise", {1, 2}), ElementsAre("transition raise 2", "transition refused 0", "error type 2"));
  EXPECT_THAT(call("raise", {0}), ElementsAre("transition raise 3", "transition refused 0", "error no_way 3"));
  EXPECT_THAT(call("beep"), ElementsAre("transition beep_below 4", "result 4"));
}

TEST_F(TableComponentTest, AHandlerWithoutArgumentsIgnoresThem) {
  EXPECT_THAT(call("beep", {1, 2, 3}), ElementsAre("transition beep_below 1", "result 1"));
}

TEST_F(TableComponentTest, AHandlerThatAcceptsMayChangeTheStateFirst) {
  call("raise", {1});
  EXPECT_THAT(call("swap", {1}),
              ElementsAre("transition replaced 0", "error replaced 1", "transition swap 2", "result 2"));
}

TEST_F(TableComponentTest, ACallThatIsRefusedBeforeItsHandlerAcceptsItIsAcceptedThen) {
  call("raise", {1});
  EXPECT_THAT(call("swap", {"high"}), ElementsAre("transition refuse_swap 2", "error type argument 2"));
}

}  // namespace
}  // namespace race::services
