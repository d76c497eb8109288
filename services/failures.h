// Failures: exceptions that reach the end of a piece of work on a thread of ours. The work is over, the thread goes on,
// and whoever keeps the log is told. What a function can name as an Error it returns; what comes here is the rest: no
// memory is left, no thread can be started, or a mistake of ours.
//
// Threads: any.
#pragma once

#include <functional>
#include <string>
#include <utility>

namespace race::services {

/// Gets a line for people. Called on the thread of the work, one at a time.
using FailureHandler = std::function<void(const std::string& text)>;

/// From now on `handler` is told of failures; an empty one: a line on stderr. When this returns, the one before is not
/// called any more. Of the whole process, as std::set_terminate is.
void set_failure_handler(FailureHandler handler);

/// Tells the handler of the exception that is being handled: `WORK failed: WHAT`. If the handler throws, it is a line
/// on stderr. To be called in a catch block, under no lock that the handler takes.
void report_failure(const char* work) noexcept;

/// Runs `function`; false: it has thrown, and that is reported.
template <typename Function>
bool run_reporting(const char* work, Function&& function) noexcept {
  try {
    std::forward<Function>(function)();
    return true;
  } catch (...) {
    report_failure(work);
    return false;
  }
}

}  // namespace race::services
