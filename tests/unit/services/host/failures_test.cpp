#include "services/failures.h"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>
#include <vector>

namespace race::services {
namespace {

struct Failures : testing::Test {
  ~Failures() override { set_failure_handler({}); }
  std::vector<std::string> told;
};

TEST_F(Failures, AreToldToTheHandlerWithWhatTheyAre) {
  set_failure_handler([this](const std::string& text) { told.push_back(text); });
  EXPECT_FALSE(run_reporting("a step", [] { throw std::runtime_error("too steep"); }));
  EXPECT_FALSE(run_reporting("a step", [] { throw std::bad_alloc(); }));
  EXPECT_FALSE(run_reporting("a step", [] { throw 5; }));
  EXPECT_EQ(told, (std::vector<std::string>{"a step failed: too steep", "a step failed: no memory is left",
                                            "a step failed: an exception without a text"}));
}

TEST_F(Failures, AreNoneOfWorkThatIsCompleted) {
  set_failure_handler([this](const std::string& text) { told.push_back(text); });
  EXPECT_TRUE(run_reporting("a step", [] {}));
  EXPECT_TRUE(told.empty());
}

TEST_F(Failures, AreALineOnStderrWithoutAHandlerOrIfItFails) {
  testing::internal::CaptureStderr();
  run_reporting("a step", [] { throw std::runtime_error("too steep"); });
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "a step failed: too steep\n");
  set_failure_handler([](const std::string&) { throw std::bad_alloc(); });
  testing::internal::CaptureStderr();
  run_reporting("a step", [] { throw std::runtime_error("too steep"); });
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "a step failed, and so did its line in the log\n");
}

}  // namespace
}  // namespace race::services
