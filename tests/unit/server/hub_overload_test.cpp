// The hub at its bounds: what is published faster than it tells, and clients that do not read.
#include <gmock/gmock.h>

#include <algorithm>
#include <future>
#include <new>
#include <thread>

#include "server/stream/hub.h"
#include "tests/unit/server/boxed_subscriber.h"
#include "tests/unit/server/resident_bytes.h"

namespace race::server {
namespace {

using testing::ElementsAre;

constexpr std::size_t kMega = 1024 * 1024;
constexpr std::int64_t kFirst = 1000;

/// Takes its messages at once, and reads those of at most 1 MiB.
struct Reader final : BoxedSubscriber {
  struct Message {
    std::string kind;
    std::int64_t sequence, state;
    bool operator==(const Message&) const = default;
  };
  void wake() override {
    if (fails) {
      fails = false;
      throw std::bad_alloc();
    }
    while (const auto text = box.pop()) {
      if ((*text)->json.size() > kMega) continue;
      const Value message = parse_json((*text)->json).value();
      const Value* data = message.find("data");
      const Value* state = data->is_dict() ? data->find("state") : data;
      read.push_back({message.find("kind")->as_string(), message.find("sequence")->as_integer() - kFirst,
                      state && state->is_integer() ? state->as_integer() : -1});
    }
  }
  std::vector<Message> read;  // on the hub's strand
  bool fails = false;         // the next time
};

using Message = Reader::Message;
std::ostream& operator<<(std::ostream& out, const Message& message) {
  return out << message.kind << ' ' << message.sequence << ' ' << message.state;
}

/// Until the hub has done what it was asked for.
void wait_for(Hub& hub) {
  const auto done = std::make_shared<std::promise<void>>();
  hub.after([done] { done->set_value(); });
  done->get_future().wait();
}

/// Channels whose state is a number, which their deltas are; `pose` is sampled, `large/0`, ... have snapshots of 20
/// MiB.
struct HubOverload : testing::Test {
  std::optional<Source> source(const std::string& name) {
    if (name == "pose") return Source{true, {}, {}};
    if (name.starts_with("large/"))
      return Source{false, [this, name] { hub.publish_snapshot(name, Value(std::string(20 * kMega, 'x'))); }, {}};
    return Source{false, [this, name] { refresh(name); }, {}};
  }
  void refresh(const std::string& name) {
    ++refreshed;
    hub.publish_snapshot(name, Value(state));
  }
  void TearDown() override { release(); }
  /// Nothing is done on the hub's strand until release().
  void block() {
    pool.post([held = blocked.get_future().share()] { held.wait(); });
  }
  /// The client gets what is published on these channels from now on, after release().
  void watch_and_block(const std::vector<std::string>& channels) {
    for (const std::string& channel : channels) hub.subscribe(client, channel, {});
    settle();
    client->read.clear();
    block();
  }
  void release() {
    if (!std::exchange(released, true)) blocked.set_value();
  }
  /// Until the hub has done what it was asked for, and what came of that.
  void settle() {
    for (int i = 0; i < 4; ++i) wait_for(hub);
  }
  /// A delta with so many bytes beside the state.
  Value next_state(std::size_t bytes = 0) {
    Value delta = Dict{{"state", ++state}, {"beside", std::string(bytes, 'x')}};
    return delta.freeze();
  }

  std::int64_t state = 0;
  int refreshed = 0;
  bool released = false;
  std::promise<void> blocked;
  Pool pool{1};
  Hub hub{pool, kFirst, [this](const std::string& name) { return source(name); }};
  std::shared_ptr<Reader> client = std::make_shared<Reader>();
};

TEST_F(HubOverload, WhatIsPublishedFasterThanItTellsTakesBoundedMemoryAndEndsInASnapshot) {
  hub.subscribe(client, "n", {});
  settle();
  const std::size_t before = resident_bytes();
  block();
  for (int i = 0; i < 100'000; ++i) hub.publish_delta("n", next_state(10'000));
  EXPECT_LT(resident_bytes(), before + 400 * kMega) << "of a gigabyte";
  EXPECT_LE(hub.waiting_units(), Publications::kMostUnits + 20'000);
  release();
  settle();
  hub.publish_delta("n", next_state());
  settle();
  EXPECT_EQ(hub.waiting_units(), 0U);
  const auto& read = client->read;
  ASSERT_EQ(read.size(), 1 + Publications::kMost + 2);
  EXPECT_EQ(read.front(), (Message{"snapshot", 0, 0}));
  for (std::int64_t i = 1; i <= std::int64_t{Publications::kMost}; ++i) EXPECT_EQ(read[i], (Message{"delta", i, i}));
  EXPECT_EQ(read[257], (Message{"snapshot", 257, 100'000})) << "nobody has its number";
  EXPECT_EQ(read[258], (Message{"delta", 258, 100'001}));
}

TEST_F(HubOverload, OfASampledChannelTheNewestIsTold) {
  hub.subscribe(client, "pose", {});
  settle();
  block();
  for (int i = 0; i < 1000; ++i) hub.publish_delta("pose", next_state());
  release();
  settle();
  EXPECT_EQ(client->read.back().state, 1000);
  EXPECT_EQ(client->read.size(), Publications::kMost + 1);
}

TEST_F(HubOverload, ChannelsAreToldInTurn) {
  watch_and_block({"much", "little"});
  for (int i = 0; i < 200; ++i) hub.publish_delta("much", next_state());
  const std::int64_t last = state + 1;
  hub.publish_delta("little", next_state());
  release();
  settle();
  ASSERT_EQ(client->read.size(), 201U);
  EXPECT_EQ(client->read[1].state, last) << "after one of the others";
  EXPECT_EQ(client->read.back().state, last - 1);
}

TEST_F(HubOverload, WhatWaitsIsNotToldWhenItsChannelIsAboutSomethingElse) {
  watch_and_block({"n", "other"});
  for (int i = 0; i < 10; ++i) hub.publish_delta("n", next_state());
  hub.publish_snapshot("n", Value(-7));
  hub.restart("n");
  for (int i = 0; i < 20; ++i) hub.publish_delta("other", next_state());
  release();
  settle();
  for (const Message& each : client->read) EXPECT_NE(each.state, -7);
  EXPECT_TRUE(std::ranges::any_of(client->read,
                                  [&](const Message& each) { return each.kind == "snapshot" && each.state == state; }));
  EXPECT_EQ(hub.waiting_units(), 0U);
}

TEST_F(HubOverload, ChannelsHaveABoundTogether) {
  block();
  for (int i = 0; i < 100; ++i)
    for (int k = 0; k < 5; ++k) hub.publish_delta("n/" + std::to_string(i), next_state(kMega));
  EXPECT_LE(hub.waiting_units(), Publications::kAllUnits + 2 * kMega);
  EXPECT_GT(hub.waiting_units(), Publications::kAllUnits - 2 * kMega);
}

TEST_F(HubOverload, ASnapshotIsToldThoughDeltasComeForEver) {
  hub.subscribe(client, "n", {});
  settle();
  block();
  for (std::size_t i = 0; i < 2 * Publications::kMost; ++i) hub.publish_delta("n", next_state());
  for (int i = 0; i < 10; ++i) {
    hub.publish_snapshot("n", Value(state));
    for (std::size_t k = 0; k < 2 * Publications::kMost; ++k) hub.publish_delta("n", next_state());
  }
  release();
  settle();
  const auto& read = client->read;
  ASSERT_EQ(read.size(), 1 + Publications::kMost + 2);
  EXPECT_EQ(read[257], (Message{"snapshot", 257, 512})) << "one, though the channel overflows";
  EXPECT_EQ(read[258], (Message{"snapshot", 258, state})) << "what came after it is dropped as well";
}

TEST_F(HubOverload, AChannelThatHasOverflownIsRemovedAsOthersAre) {
  hub.subscribe(client, "n", {});
  settle();
  block();
  for (std::size_t i = 0; i < 2 * Publications::kMost; ++i) hub.publish_delta("n", next_state());
  hub.close("n", {{ErrorCode::not_found, "was removed", "n"}});
  release();
  settle();
  EXPECT_EQ(client->read.back().kind, "error");
  const int before = refreshed;
  hub.publish_delta("n", next_state());
  hub.subscribe(client, "n", {});
  settle();
  EXPECT_EQ(refreshed, before + 1);
  EXPECT_EQ(client->read.back().state, state);
}

TEST_F(HubOverload, AClientThatIsTooSlowAsWellGetsItsSnapshot) {
  const auto slow = std::make_shared<BoxedSubscriber>();
  hub.subscribe(slow, "n", {});
  settle();
  for (std::size_t i = 0; i < Outbox::kMessages + 1; ++i) {
    hub.publish_delta("n", next_state());
    settle();
  }
  EXPECT_THAT(slow->box.take_stale_channels(), ElementsAre("n"));
  block();
  for (std::size_t i = 0; i < 2 * Publications::kMost; ++i) hub.publish_delta("n", next_state());
  hub.resend_snapshot(slow, "n");  // while it waits for the one of the channel
  release();
  settle();
  const auto messages = slow->messages();
  ASSERT_FALSE(messages.empty());
  EXPECT_EQ(messages.back().find("data")->as_integer(), state);
}

TEST_F(HubOverload, ADeltaThatFailsIsMadeUpForByASnapshot) {
  const auto other = std::make_shared<Reader>();
  for (const auto& each : {client, other}) hub.subscribe(each, "n", {});
  settle();
  client->fails = true;
  hub.publish_delta("n", next_state());
  settle();
  for (const auto& each : {client, other}) EXPECT_EQ(each->read.back(), (Message{"snapshot", 2, 1}));
}

TEST_F(HubOverload, ASnapshotThatFailsIsNotAskedForAgainAndAgain) {
  client->fails = true;
  hub.subscribe(client, "n", {});
  settle();
  EXPECT_EQ(refreshed, 1);
  const auto other = std::make_shared<Reader>();
  hub.subscribe(other, "n", {});
  settle();
  for (const auto& each : {client, other}) EXPECT_EQ(each->read.back().kind, "snapshot");
}

// As a core does: its strand publishes both.
TEST_F(HubOverload, EachDeltaComesInItsOrderOrASnapshotStandsForIt) {
  std::atomic<bool> asked = false;
  Pool own{1};
  Hub busy{own, kFirst, [&](const std::string&) { return Source{false, [&] { asked = true; }, {}}; }};
  busy.subscribe(client, "n", {});
  for (int i = 0; i < 200'000; ++i) {
    busy.publish_delta("n", next_state());
    if (asked.exchange(false)) busy.publish_snapshot("n", Value(state));
  }
  for (int i = 0; i < 6; ++i) {  // until nothing is asked for any more
    wait_for(busy);
    if (asked.exchange(false)) busy.publish_snapshot("n", Value(state));
  }
  Message last{"", -1, -1};
  int snapshots = 0;
  for (const Message& each : client->read) {
    if (each.kind == "delta") {
      ASSERT_EQ(each, (Message{"delta", last.sequence + 1, last.state + 1}));
    } else {
      ++snapshots;
      ASSERT_GE(each.sequence, last.sequence);
      ASSERT_GE(each.state, last.state);
    }
    last = each;
  }
  EXPECT_EQ(last.state, 200'000);
  EXPECT_GT(snapshots, 1) << "it has never overflown: the test tests nothing";
}

TEST_F(HubOverload, TheClientThatHoldsMostIsCutWhenAllHoldTooMuch) {
  std::vector<std::shared_ptr<BoxedSubscriber>> silent;
  for (int i = 0; i < 30; ++i) {
    silent.push_back(std::make_shared<BoxedSubscriber>());
    hub.subscribe(silent.back(), "n/" + std::to_string(i), {});
  }
  hub.send(silent[3], "n", "note", Value(std::string(7 * kMega, 'x')));
  for (int i = 0; i < 30; ++i)
    if (i != 3) hub.send(silent[i], "n", "note", Value(std::string((i < 20 ? 6 : 2) * kMega, 'x')));
  settle();
  EXPECT_LE(hub.message_bytes(), Hub::kMaxBytes);
  EXPECT_TRUE(silent[3]->box.is_cut());
  EXPECT_EQ(std::ranges::count_if(silent, [](const auto& each) { return each->box.is_cut(); }), 3);
  for (int i = 20; i < 30; ++i) EXPECT_EQ(silent[i]->box.size(), 2U);
}

TEST_F(HubOverload, NobodyIsCutForWhatAllShare) {
  std::vector<std::shared_ptr<BoxedSubscriber>> silent;
  for (int i = 0; i < 100; ++i) {
    silent.push_back(std::make_shared<BoxedSubscriber>());
    hub.subscribe(silent.back(), "large/0", {});
  }
  settle();
  EXPECT_LE(hub.message_bytes(), 2 * 21 * kMega) << "the snapshot for the first, and that for who came meanwhile";
  for (const auto& each : silent) EXPECT_EQ(each->box.size(), 1U);
}

TEST_F(HubOverload, WhatChannelsKeepIsDroppedBeforeAClientIsCut) {
  const auto name = [](int i) { return "large/" + std::to_string(i); };
  for (int i = 0; i < 10; ++i) hub.subscribe(client, name(i), {});
  settle();
  EXPECT_LE(hub.message_bytes(), Hub::kMaxBytes);
  EXPECT_GT(hub.message_bytes(), Hub::kMaxBytes - 21 * kMega) << "no more than needed";
  EXPECT_FALSE(client->box.is_cut());
  for (int i = 0; i < 10; ++i) {
    hub.publish_delta(name(i), Value(1));
    hub.subscribe(client, name(i), kFirst);
  }
  settle();
  EXPECT_EQ(client->read, std::vector(20, Message{"delta", 1, 1})) << "numbers go on";
}

}  // namespace
}  // namespace race::server
