#include "services/failures.h"

#include <cstdio>
#include <exception>
#include <new>

#include "services/mutex.h"

namespace race::services {
namespace {

struct FailureSink {
  Mutex mutex;
  FailureHandler call GUARDED_BY(mutex);
};

// Never destroyed: threads may still end when the program does.
FailureSink& failure_sink() {
  static FailureSink* const instance = new FailureSink();
  return *instance;
}

// Of the exception that is being handled.
std::string text_of(const char* work) {
  const std::string failed = std::string(work) + " failed: ";
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return failed + "no memory is left";
  } catch (const std::exception& failure) {
    return failed + failure.what();
  } catch (...) {
    return failed + "an exception without a text";
  }
}

}  // namespace

void set_failure_handler(FailureHandler call) {
  FailureSink& set = failure_sink();
  const MutexLock lock(set.mutex);
  set.call.swap(call);
}

void report_failure(const char* work) noexcept {
  try {
    const std::string text = text_of(work);
    FailureSink& set = failure_sink();
    const MutexLock lock(set.mutex);
    if (set.call) return set.call(text);
    std::fprintf(stderr, "%s\n", text.c_str());
  } catch (...) {  // what needs no memory
    std::fprintf(stderr, "%s failed, and so did its line in the log\n", work);
  }
}

}  // namespace race::services
