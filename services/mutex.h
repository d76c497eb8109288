// Mutex, MutexLock and ConditionVariable: the standard ones with clang's thread safety attributes. A member names the
// mutex that guards it, a function the mutexes that it needs or must not hold; deploy/check_locks compiles services and
// server with clang and fails where code breaks this. g++ ignores the attributes.
//
//   Mutex mutex_;
//   std::vector<Work> work_ GUARDED_BY(mutex_);
//   void sort() REQUIRES(mutex_);  // the caller holds it
//   void post(Work work) EXCLUDES(mutex_);  // takes it itself
//
// A lambda that runs under the lock says so: `[this]() REQUIRES(mutex_) { return !work_.empty(); }`.
//
// Threads: any.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>

#ifdef __clang__
#define RACE_ATTRIBUTE(attribute) __attribute__((attribute))
#else
#define RACE_ATTRIBUTE(attribute)
#endif

/// Of a member: it is read and written under the mutex alone. PT_: what the pointer points to is.
#define GUARDED_BY(mutex) RACE_ATTRIBUTE(guarded_by(mutex))
#define PT_GUARDED_BY(mutex) RACE_ATTRIBUTE(pt_guarded_by(mutex))
/// Of a function: its caller holds the mutexes, or holds none of them.
#define REQUIRES(...) RACE_ATTRIBUTE(requires_capability(__VA_ARGS__))
#define EXCLUDES(...) RACE_ATTRIBUTE(locks_excluded(__VA_ARGS__))
/// Of a function: it takes or gives back the mutex; without an argument, the object itself.
#define ACQUIRE(...) RACE_ATTRIBUTE(acquire_capability(__VA_ARGS__))
#define RELEASE(...) RACE_ATTRIBUTE(release_capability(__VA_ARGS__))

namespace race::services {

class RACE_ATTRIBUTE(capability("mutex")) Mutex {
 public:
  void lock() ACQUIRE() { mutex_.lock(); }
  void unlock() RELEASE() { mutex_.unlock(); }

 private:
  friend class ConditionVariable;
  std::mutex mutex_;
};

/// Holds a mutex while it lives.
class RACE_ATTRIBUTE(scoped_lockable) MutexLock {
 public:
  explicit MutexLock(Mutex& mutex) ACQUIRE(mutex) : mutex_(mutex) { mutex_.lock(); }
  ~MutexLock() RELEASE() { mutex_.unlock(); }
  MutexLock(const MutexLock&) = delete;
  MutexLock& operator=(const MutexLock&) = delete;

 private:
  Mutex& mutex_;
};

/// Waits for a condition under a mutex, which it gives back meanwhile. The condition is a lambda that REQUIRES(mutex).
class ConditionVariable {
 public:
  void notify_one() { condition_.notify_one(); }
  void notify_all() { condition_.notify_all(); }

  template <typename Condition>
  void wait(Mutex& mutex, Condition condition) REQUIRES(mutex) {
    with(mutex, [&](auto& lock) {
      condition_.wait(lock, std::move(condition));
      return true;
    });
  }
  /// Whether the condition was met within `time`.
  template <typename Rep, typename Period, typename Condition>
  bool wait_for(Mutex& mutex, std::chrono::duration<Rep, Period> time, Condition condition) REQUIRES(mutex) {
    return with(mutex, [&](auto& lock) { return condition_.wait_for(lock, time, std::move(condition)); });
  }

 private:
  /// Lends the mutex, which is held, to the standard library.
  template <typename Wait>
  bool with(Mutex& mutex, Wait wait) REQUIRES(mutex) {
    std::unique_lock lock(mutex.mutex_, std::adopt_lock);
    const bool met = wait(lock);
    lock.release();
    return met;
  }

  std::condition_variable condition_;
};

}  // namespace race::services
