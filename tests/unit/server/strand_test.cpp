#include "server/threads/strand.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "services/failures.h"

namespace race::server {
namespace {

TEST(Strand, RunsInOrderAndNeverTwoAtATime) {
  Pool pool(4);
  Strand strand(pool);
  std::vector<int> order;  // unguarded: the strand is the guard
  for (int i = 0; i < 2000; ++i) strand.post([&order, i] { order.push_back(i); });
  EXPECT_EQ(strand.ask([&] { return order.size(); }), 2000U);
  for (int i = 0; i < 2000; ++i) EXPECT_EQ(order[static_cast<std::size_t>(i)], i);
}

TEST(Strand, ABusyOneDoesNotHoldUpAnother) {
  Pool pool(2);
  Strand busy(pool), other(pool);
  std::atomic<bool> release{false};
  busy.post([&] {
    while (!release) std::this_thread::yield();
  });
  EXPECT_EQ(other.ask([] { return 5; }), 5);
  EXPECT_EQ(busy.ask([] { return 5; }, std::chrono::milliseconds(1)), std::nullopt);
  release = true;
  EXPECT_EQ(busy.ask([] { return 6; }), 6);
}

TEST(Pool, DoesWhatIsPostedForLaterAfterAllElse) {
  Pool pool(1);
  std::string order;  // of the pool's one thread
  std::promise<void> posted;
  pool.post([&] { posted.get_future().wait(); });
  for (char c = 'a'; c < 'd'; ++c) pool.post([&order, c] { order += c; }, Pool::Turn::later);
  for (char c = 'A'; c < 'D'; ++c) pool.post([&order, c] { order += c; });
  posted.set_value();
  pool.end();
  EXPECT_EQ(order, "ABCabc");
}

TEST(Pool, DoesWhatIsPostedForLaterNowAndThenHoweverMuchElseThereIs) {
  Pool pool(1);
  std::string order;
  std::promise<void> posted;
  pool.post([&] { posted.get_future().wait(); });
  pool.post([&order] { order += 'l'; }, Pool::Turn::later);
  pool.post([&order] { order += 'l'; }, Pool::Turn::later);
  for (unsigned i = 0; i < 3 * Pool::kLaterAfter; ++i) pool.post([&order] { order += '.'; });
  posted.set_value();
  pool.end();
  EXPECT_EQ(order, ".......l........l.........");
}

TEST(Pool, HasThreadsThatTheRestOfTurnsDoesNotTake) {
  Pool pool(1, 1);
  std::promise<void> release, done;
  pool.post([&] { release.get_future().wait(); }, Pool::Turn::later);
  pool.post([&] { done.set_value(); });
  EXPECT_EQ(done.get_future().wait_for(std::chrono::seconds(5)), std::future_status::ready);
  release.set_value();
  pool.end();
}

TEST(Strand, ThatIsAskedDoesNotWaitForTheRestOfTurnsOfOthers) {
  Pool pool(1, 1);
  Strand busy(pool), asked(pool);
  std::promise<void> release;
  std::string order;  // of `asked`
  busy.post_later([&] { release.get_future().wait(); });
  asked.post_later([&] { order += 'l'; });
  EXPECT_EQ(asked.ask([&] { return order += 'n'; }), "n");
  release.set_value();
  busy.finish();
  pool.end();
}

TEST(Strand, DoesTheRestOfItsTurnNowAndThenHoweverMuchElseThereIs) {
  Pool pool(1);
  Strand strand(pool);
  std::string order;
  std::promise<void> posted;
  pool.post([&] { posted.get_future().wait(); });
  strand.post_later([&] { order += 'l'; });
  for (unsigned i = 0; i < 2 * Pool::kLaterAfter; ++i) strand.post([&] { order += '.'; });
  posted.set_value();
  strand.finish();
  EXPECT_EQ(order, "........l........");
}

TEST(Strand, ThatHasLittleToDoGoesBeforeTheRestOfTurns) {
  Pool pool(1);
  Strand busy(pool), other(pool), good(pool);
  std::string order;  // of the pool's one thread
  std::promise<void> posted;
  pool.post([&] { posted.get_future().wait(); });
  busy.post_later([&] {
    order += 'b';
    busy.post_later([&] { order += 'c'; });
  });
  other.post_later([&] { order += 'o'; });
  good.post([&] { order += 'g'; });
  posted.set_value();
  for (Strand* each : {&busy, &other, &good}) each->finish();
  EXPECT_EQ(order, "gboc");
}

TEST(Strand, DoesTheRestOfItsTurnLast) {
  Pool pool(1);
  Strand strand(pool);
  std::string order;
  std::promise<void> posted;
  pool.post([&] { posted.get_future().wait(); });
  strand.post_later([&] { order += '1'; });
  strand.post([&] { order += '2'; });
  posted.set_value();
  strand.finish();
  EXPECT_EQ(order, "21");
}

TEST(Pool, DropsWhatWaitsAndDoesWhatComesLater) {
  std::atomic<bool> begun{false}, release{false};
  std::atomic<int> done{0};
  const auto held = std::make_shared<int>();
  {
    Pool pool(1);
    pool.post([&] {
      begun = true;
      while (!release) std::this_thread::yield();
      ++done;
    });
    while (!begun) std::this_thread::yield();
    pool.post([&, held] { done += 10; });
    pool.drop();
    EXPECT_EQ(held.use_count(), 1);
    pool.post([&] { done += 100; });
    release = true;
  }
  EXPECT_EQ(done, 101);
}

/// What is reported while it lives.
struct Reported {
  Reported() {
    services::set_failure_handler([this](const std::string& text) { texts.push_back(text); });
  }
  ~Reported() { services::set_failure_handler({}); }
  Reported(const Reported&) = delete;
  Reported& operator=(const Reported&) = delete;
  std::vector<std::string> texts;  // one at a time
};

TEST(Strand, GoesOnAfterWorkThatThrows) {
  Reported reported;
  {
    Pool pool(2);
    Strand strand(pool);
    strand.post([] { throw std::runtime_error("no"); });
    strand.post([] { throw std::bad_alloc(); });
    EXPECT_EQ(strand.ask([] { return 5; }), 5);
    strand.post([] { throw std::runtime_error("nor that"); });
    strand.finish();
  }
  EXPECT_EQ(reported.texts,
            (std::vector<std::string>{"work of a strand failed: no", "work of a strand failed: no memory is left",
                                      "work of a strand failed: nor that"}));
}

TEST(Strand, WhoAsksGetsTheException) {
  const Reported reported;
  Pool pool(1);
  Strand strand(pool);
  EXPECT_THROW(strand.ask([]() -> int { throw std::runtime_error("no"); }), std::runtime_error);
  EXPECT_EQ(strand.ask([] { return 5; }), 5);
  EXPECT_TRUE(reported.texts.empty());
}

TEST(Strand, CanWaitUntilItsWorkIsDone) {
  Pool pool(2);
  Strand strand(pool);
  strand.finish();  // none
  int done = 0;     // of the strand alone
  for (int i = 0; i < 3; ++i)
    strand.post([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      ++done;
    });
  strand.finish();
  EXPECT_EQ(done, 3);
}

TEST(Pool, GoesOnAfterWorkThatThrows) {
  Reported reported;
  std::atomic<int> done{0};
  {
    Pool pool(1);
    pool.post([] { throw std::runtime_error("no"); });
    pool.post([&] { ++done; });
  }
  EXPECT_EQ(done, 1);
  EXPECT_EQ(reported.texts, std::vector<std::string>{"work of a thread failed: no"});
}

TEST(Pool, DoesEverythingBeforeItEnds) {
  std::atomic<int> done{0};
  {
    Pool pool(2);
    const auto strand = std::make_shared<Strand>(pool);  // its tasks, which post another one, keep it
    for (int i = 0; i < 100; ++i)
      strand->post([&done, strand] {
        ++done;
        strand->post([&done, strand] { ++done; });
      });
  }
  EXPECT_EQ(done, 200);
}

TEST(Pool, DropsWhatIsPostedOnceItHasEnded) {
  Pool pool(2);
  Strand strand(pool);
  EXPECT_TRUE(pool.post([] {}));
  pool.end();
  bool done = false;
  const auto owned = std::make_shared<int>();
  EXPECT_FALSE(pool.post([&] { done = true; }));
  for (int i = 0; i < 2; ++i) strand.post([&done, owned] { done = true; });
  EXPECT_EQ(owned.use_count(), 1);
  EXPECT_EQ(strand.ask([] { return 5; }), std::nullopt);
  strand.finish();  // does not wait for it
  EXPECT_FALSE(done);
}

}  // namespace
}  // namespace race::server
