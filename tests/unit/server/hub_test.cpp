#include "server/stream/hub.h"

#include <gmock/gmock.h>

#include "core/value/json.h"
#include "tests/unit/server/boxed_subscriber.h"

namespace race::server {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct HubClient final : BoxedSubscriber {
  // What came since: "kind sequence-first data".
  std::vector<std::string> received() {
    std::vector<std::string> out;
    for (const Value& message : messages()) {
      out.push_back(message.find("kind")->as_string() + " " +
                    std::to_string(message.find("sequence")->as_integer() - HubFirst) + " " +
                    (message.find("data")->is_integer() ? std::to_string(message.find("data")->as_integer()) : "-"));
    }
    return out;
  }
  static constexpr std::int64_t HubFirst = 1000;
};

// A channel `n` whose state is a number: its deltas are the new number. So are `n/0`, `n/1`, ... `pose` is sampled,
// `seen` is published only while it is watched; the state of `large/0`, ... is a text of a third of kMaxIdleBytes.
struct HubTest : testing::Test {
  std::optional<Source> source(const std::string& name) {
    if (name == "n" || name.starts_with("n/")) return Source{false, [this, name] { refresh(name); }, {}};
    if (name.starts_with("large/")) {
      return Source{false,
                    [this, name] {
                      ++refreshed;
                      hub.publish_snapshot(name, Value(std::string(Hub::kMaxIdleBytes / 3, 'x')));
                    },
                    {}};
    }
    if (name == "pose") return Source{true, {}, [this](bool on) { watched = on; }};
    if (name == "seen") return Source{false, [this] { refresh("seen"); }, [this](bool on) { watched = on; }};
    return std::nullopt;
  }
  void refresh(const std::string& name) {
    ++refreshed;
    hub.publish_snapshot(name, Value(state));
  }
  void delta(const std::string& name = "n") { hub.publish_delta(name, Value(++state)); }
  // So many as the hub has time for: it drops what is published faster (publications.h).
  void deltas(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      if (i % 100 == 99) settle();
      delta();
    }
  }
  // Until the hub has done what it was asked for.
  void settle() {
    // Each of its strands does one thing at a time in turn on the one thread; the hub has at most kMaxDeltas + 10 to
    // do.
    for (std::size_t i = 0; i < Hub::kMaxDeltas + 10; ++i) Strand(pool).ask([] { return 0; });
  }
  std::vector<std::string> received(const std::shared_ptr<HubClient>& client) {
    settle();
    return client->received();
  }

  Pool pool{1};
  Hub hub{pool, HubClient::HubFirst, [this](const std::string& name) { return source(name); }};
  int state = 0, refreshed = 0;
  bool watched = false;
  std::shared_ptr<HubClient> client = std::make_shared<HubClient>(), other = std::make_shared<HubClient>();
};

TEST_F(HubTest, SendsASnapshotThenDeltas) {
  hub.subscribe(client, "n", {});
  settle();
  delta();
  delta();
  EXPECT_THAT(received(client), ElementsAre("snapshot 0 0", "delta 1 1", "delta 2 2"));
}

TEST_F(HubTest, ALaterSubscriberGetsANewSnapshotIfSomethingHasChanged) {
  hub.subscribe(client, "n", {});
  settle();
  delta();
  hub.subscribe(other, "n", {});
  settle();
  delta();
  EXPECT_THAT(received(other), ElementsAre("snapshot 1 1", "delta 2 2"));
  EXPECT_EQ(refreshed, 2);
}

TEST_F(HubTest, ALaterSubscriberGetsTheKeptSnapshotIfNothingHasChanged) {
  hub.subscribe(client, "n", {});
  settle();
  hub.subscribe(other, "n", {});
  settle();
  delta();
  EXPECT_THAT(received(other), ElementsAre("snapshot 0 0", "delta 1 1"));
  EXPECT_EQ(refreshed, 1);
}

TEST_F(HubTest, WhenWhatIsKeptDoesNotReachTheSourceIsAsked) {
  hub.subscribe(client, "n", {});
  settle();
  deltas(Hub::kMaxDeltas + 1);
  settle();
  hub.subscribe(other, "n", {});
  EXPECT_THAT(received(other), ElementsAre("snapshot 257 257"));
  EXPECT_EQ(refreshed, 2);
}

TEST_F(HubTest, WhoComesAgainGetsWhatItMissed) {
  hub.subscribe(client, "n", {});
  settle();
  delta();
  settle();
  hub.disconnect(client);
  delta();
  delta();
  hub.subscribe(other, "n", HubClient::HubFirst + 1);
  EXPECT_THAT(received(other), ElementsAre("delta 2 2", "delta 3 3"));
  hub.subscribe(other, "n", HubClient::HubFirst + 3);
  delta();
  EXPECT_THAT(received(other), ElementsAre("delta 4 4"));
}

TEST_F(HubTest, ANumberOfAnotherServerGetsASnapshot) {
  hub.subscribe(client, "n", HubClient::HubFirst - 5);
  EXPECT_THAT(received(client), ElementsAre("snapshot 0 0"));
  hub.subscribe(other, "n", HubClient::HubFirst + 5);
  EXPECT_THAT(received(other), ElementsAre("snapshot 0 0"));
}

TEST_F(HubTest, WhoHasMissedMoreThanIsKeptGetsASnapshot) {
  hub.subscribe(client, "n", {});
  settle();
  deltas(Hub::kMaxDeltas + 1);
  hub.subscribe(other, "n", HubClient::HubFirst + 1);
  const auto all = received(other);
  ASSERT_EQ(all.size(), Hub::kMaxDeltas);
  EXPECT_EQ(all.front(), "delta 2 2");
  hub.subscribe(other, "n", HubClient::HubFirst);
  EXPECT_THAT(received(other), ElementsAre("snapshot 257 257"));
}

TEST_F(HubTest, ASlowSubscriberGetsNothingBeforeTheSnapshotThatItNeeds) {
  hub.subscribe(client, "n", {});
  settle();
  deltas(Outbox::kMessages + 1);
  EXPECT_THAT(received(client), IsEmpty());
  EXPECT_THAT(client->box.take_stale_channels(), ElementsAre("n"));
  delta();  // on its way when the snapshot is asked for
  EXPECT_THAT(received(client), IsEmpty());
  hub.resend_snapshot(client, "n");
  settle();
  delta();
  EXPECT_THAT(received(client), ElementsAre("snapshot 258 258", "delta 259 259"));
}

TEST_F(HubTest, AFormerSubscriberGetsNoSnapshot) {
  hub.subscribe(client, "n", {});
  settle();
  deltas(Outbox::kMessages + 1);
  settle();
  EXPECT_THAT(client->box.take_stale_channels(), ElementsAre("n"));
  hub.unsubscribe(client, "n");
  hub.resend_snapshot(client, "n");
  delta();
  EXPECT_THAT(received(client), IsEmpty());
}

TEST_F(HubTest, NoAnswerComesAfterTooManyThatWereDropped) {
  for (std::size_t i = 0; i < Outbox::kMessages + 1; ++i) hub.subscribe(client, "nothing", {});
  EXPECT_THAT(received(client), IsEmpty());
  EXPECT_THAT(client->box.take_stale_channels(), ElementsAre(Outbox::kPrivateQueue)) << "its connection has to end";
  hub.subscribe(client, "nothing", {});
  EXPECT_THAT(received(client), IsEmpty());
}

TEST_F(HubTest, ASampledChannelIsWholeInEveryMessage) {
  hub.subscribe(client, "pose", {});
  settle();
  EXPECT_TRUE(watched);
  delta("pose");
  EXPECT_THAT(received(client), ElementsAre("snapshot 1 1"));
  delta("pose");
  delta("pose");
  EXPECT_THAT(received(client), ElementsAre("delta 3 3"));
  hub.unsubscribe(client, "pose");
  delta("pose");
  EXPECT_THAT(received(client), IsEmpty());
  EXPECT_FALSE(watched);
}

TEST_F(HubTest, WhatIsPublishedOnlyWhileWatchedBeginsAnewAfterAGap) {
  hub.subscribe(client, "seen", {});
  settle();
  delta("seen");
  EXPECT_THAT(received(client), ElementsAre("snapshot 0 0", "delta 1 1"));
  hub.disconnect(client);
  settle();
  EXPECT_FALSE(watched);
  state = 50;
  hub.subscribe(client, "seen", {});
  EXPECT_THAT(received(client), ElementsAre("snapshot 1 50"));
}

TEST_F(HubTest, AnUnknownChannelAndAnEndedOneAreErrors) {
  hub.subscribe(client, "nothing", {});
  EXPECT_THAT(received(client), ElementsAre("error 0 -"));
  hub.subscribe(client, "n", {});
  settle();
  hub.close("n", {{ErrorCode::corrupt, "is damaged", "n"}});
  settle();
  const std::vector<Value> messages = client->messages();
  ASSERT_EQ(messages.size(), 2U);
  EXPECT_EQ(messages[1].find("sequence")->as_integer(), HubClient::HubFirst + 1);
  const Value& error = messages[1].find("data")->find("errors")->as_list().at(0);
  EXPECT_EQ(error.find("code")->as_string(), "corrupt");
}

TEST_F(HubTest, AChannelOfTheNameOfOneThatHasEndedHasOtherNumbers) {
  hub.subscribe(client, "n", {});
  settle();
  delta();
  hub.close("n", {{ErrorCode::not_found, "was removed", "n"}});
  hub.subscribe(other, "n", {});
  settle();
  delta();
  delta();
  EXPECT_THAT(received(other), ElementsAre("snapshot 3 1", "delta 4 2", "delta 5 3"));
  EXPECT_THAT(received(client), ElementsAre("snapshot 0 0", "delta 1 1", "error 2 -"));
  hub.subscribe(client, "n", HubClient::HubFirst + 1);
  EXPECT_THAT(received(client), ElementsAre("snapshot 5 3")) << "none of the deltas after those of the ended one";
}

TEST_F(HubTest, OneSerialisationIsSharedByAllSubscribers) {
  hub.subscribe(client, "n", {});
  hub.subscribe(other, "n", {});
  settle();
  client->received();
  other->received();
  delta();
  settle();
  EXPECT_EQ(client->box.pop()->get(), other->box.pop()->get());
}

TEST_F(HubTest, AMessageSaysBesideItsTextWhatTheTextSays) {
  hub.subscribe(client, "n", {});
  settle();
  delta();
  hub.publish_delta("n", Value(std::string(2 * Publication::kLargeUnits, 'x')));  // is serialised by who publishes it
  hub.subscribe(client, "nothing", {});
  settle();
  for (const char* kind : {"snapshot", "delta", "delta", "error"}) {
    const Text message = client->box.pop().value();
    const Value json = parse_json(message->json).value();
    EXPECT_EQ(message->kind, kind);
    EXPECT_EQ(json.find("kind")->as_string(), kind);
    EXPECT_EQ(json.find("sequence")->as_integer(), message->sequence);
  }
}

TEST_F(HubTest, ReplacesWhatAllSubscribersHave) {
  hub.subscribe(client, "n", {});
  settle();
  delta();
  hub.publish_replacement("n", Value(70));
  delta();
  EXPECT_THAT(received(client), ElementsAre("snapshot 0 0", "delta 1 1", "snapshot 2 70", "delta 3 2"));
}

TEST_F(HubTest, LeadsNobodyOverAReplacementByDeltas) {
  hub.subscribe(client, "n", {});
  settle();
  delta();
  hub.publish_replacement("n", Value(70));
  hub.subscribe(other, "n", HubClient::HubFirst + 1);
  EXPECT_THAT(received(other), ElementsAre("snapshot 2 70"));
}

TEST_F(HubTest, AsksForNewSnapshotsOfTheChannelsThatItRestarts) {
  hub.subscribe(client, "n", {});
  hub.subscribe(other, "seen", {});
  settle();
  received(client);
  state = 5;
  hub.restart("n");
  EXPECT_THAT(received(client), ElementsAre("snapshot 1 5"));
  EXPECT_THAT(received(other), ElementsAre("snapshot 0 0"));
}

TEST_F(HubTest, SendsToOneClientAloneAndOnlyIfItDoesNotHearTheChannel) {
  hub.subscribe(client, "n", {});
  settle();
  received(client);
  for (const auto& each : {client, other}) hub.send(each, "n", "note", Value(1), Hub::To::those_not_subscribed);
  EXPECT_THAT(received(client), IsEmpty());
  EXPECT_THAT(received(other), ElementsAre("note 0 1"));
  hub.send(client, "n", "note", Value(2));
  EXPECT_THAT(received(client), ElementsAre("note 0 2"));
  hub.send(std::make_shared<HubClient>(), "n", "note", Value(3));  // it is gone
  EXPECT_THAT(received(client), IsEmpty());
}

TEST_F(HubTest, AClientHasABoundedNumberOfChannels) {
  for (std::size_t i = 0; i < Hub::kMaxSubscriptions; ++i) hub.subscribe(client, "n/" + std::to_string(i), {});
  for (int i = 0; i < 2; ++i) settle();  // it has twice as many things to do as for one channel's deltas
  EXPECT_EQ(received(client).size(), Hub::kMaxSubscriptions);
  hub.subscribe(client, "n", {});
  hub.subscribe(client, "n/7", {});  // which it has
  settle();
  const std::vector<Value> messages = client->messages();
  ASSERT_EQ(messages.size(), 2U);
  const Value& error = messages[0].find("data")->find("errors")->as_list().at(0);
  EXPECT_EQ(error.find("code")->as_string(), "too_large");
  EXPECT_EQ(error.find("path")->as_string(), "n");
  EXPECT_EQ(messages[1].find("channel")->as_string(), "n/7");
  hub.unsubscribe(client, "n/7");
  hub.subscribe(client, "n", {});
  EXPECT_THAT(received(client), ElementsAre("snapshot 0 0"));
}

TEST_F(HubTest, ForgetsWhatNobodyHasSubscribedToForLong) {
  const auto join_and_leave = [this](const std::string& name) {
    hub.subscribe(client, name, {});
    settle();
    hub.unsubscribe(client, name);
    settle();
  };
  for (std::size_t i = 0; i <= Hub::kMaxIdle; ++i) join_and_leave("n/" + std::to_string(i));
  client->received();
  refreshed = 0;
  hub.subscribe(client, "n/1", HubClient::HubFirst);
  EXPECT_THAT(received(client), ElementsAre("snapshot 0 0")) << "it is kept";
  EXPECT_EQ(refreshed, 0);
  hub.subscribe(client, "n/0", HubClient::HubFirst);
  EXPECT_THAT(received(client), ElementsAre("snapshot 2 0")) << "it was forgotten: its numbers are new";
  EXPECT_EQ(refreshed, 1);
}

TEST_F(HubTest, KeepsABoundedAmountOfWhatNobodyHasSubscribedTo) {
  for (const char* name : {"large/0", "large/1", "large/2"}) {
    hub.subscribe(client, name, {});
    settle();
    client->received();
    hub.unsubscribe(client, name);
    settle();
  }
  refreshed = 0;
  hub.subscribe(client, "large/1", {});
  settle();
  EXPECT_EQ(refreshed, 0);
  hub.subscribe(client, "large/0", {});
  settle();
  EXPECT_EQ(refreshed, 1);
}

TEST_F(HubTest, DeltasThatNobodyGetsAreKeptInSmallAmounts) {
  hub.subscribe(client, "n", {});
  settle();
  hub.unsubscribe(client, "n");
  const std::string text(Hub::kMaxIdleDeltaBytes / 3, 'x');
  for (int i = 0; i < 5; ++i) hub.publish_delta("n", Value(text));
  hub.subscribe(client, "n", HubClient::HubFirst + 3);
  EXPECT_THAT(received(client), ElementsAre("delta 4 -", "delta 5 -"));
  hub.subscribe(other, "n", HubClient::HubFirst + 2);
  EXPECT_THAT(received(other), ElementsAre("snapshot 5 0")) << "the third is not kept any more";
}

TEST_F(HubTest, SaysWhenItHasDoneWhatItWasAskedFor) {
  std::vector<std::string> had;
  hub.subscribe(client, "nothing", {});
  hub.after([&] { had = client->received(); });
  settle();
  EXPECT_THAT(had, ElementsAre("error 0 -"));
}

}  // namespace
}  // namespace race::server
