// What clients say of the persons at them, on the channels presence/NAME: who is told what, and when somebody has left.
#include "server/editing/presence_channels.h"

#include <gmock/gmock.h>

#include "tests/unit/server/boxed_subscriber.h"

namespace race::server {
namespace {

using std::chrono::milliseconds;

struct PresentClient final : BoxedSubscriber {
  /// Waits for the next message: "joined 1", "snapshot Ada", "delta Ada -1", "error too_large".
  std::string heard() {
    const Value message = next();
    const Value& data = *message.find("data");
    std::string out = message.find("kind")->as_string();
    if (const Value* id = data.find("id")) out += " " + std::to_string(id->as_integer());
    if (const Value* people = data.find("people"))
      for (const Value& each : people->as_list()) out += " " + each.find("name")->as_string();
    if (const Value* left = data.find("left"))
      for (const Value& each : left->as_list()) out += " -" + std::to_string(each.as_integer());
    if (const Value* errors = data.find("errors")) out += " " + errors->as_list()[0].find("code")->as_string();
    return out;
  }
};

class PresenceChannelsTest : public testing::Test {
 protected:
  using Client = std::shared_ptr<PresentClient>;
  static Client client() { return std::make_shared<PresentClient>(); }
  void say(const Client& client, const std::string& name, PresenceChannels& channels) {
    channels.request_presence(client, Dict{{"type", "presence"}, {"document", "task"}, {"name", name}});
  }
  void say(const Client& client, const std::string& name) { say(client, name, channels_); }
  Client watcher() {
    Client out = client();
    hub_.subscribe(out, "presence/task", {});
    EXPECT_EQ(out->heard(), "snapshot");
    return out;
  }
  ~PresenceChannelsTest() override {
    deadlines_.close();
    hub_.shut_down();
  }

  Pool pool_{1};
  Hub hub_{pool_, 1000, [this](const std::string&) {
             return Source{false, [this] { channels_.publish_snapshot("task"); }, {}};
           }};
  Deadlines deadlines_;
  PresenceChannels channels_{hub_, deadlines_, 1};
};

TEST_F(PresenceChannelsTest, TellOthersWhoHasComeAndThePersonWhoTheyAre) {
  const Client bob = watcher(), ada = client();
  say(ada, "Ada");
  EXPECT_EQ(ada->heard(), "joined 1");
  EXPECT_EQ(bob->heard(), "delta Ada");
  const Client late = client();
  hub_.subscribe(late, "presence/task", {});
  EXPECT_EQ(late->heard(), "snapshot Ada");
}

TEST_F(PresenceChannelsTest, TellTheLastOfManyMessages) {
  const Client bob = watcher(), ada = client();
  for (int i = 0; i < 1000; ++i) say(ada, "Ada" + std::to_string(i));
  std::size_t deltas = 1;
  while (bob->heard() != "delta Ada999") ++deltas;
  EXPECT_LT(deltas, 500U) << "not each of them";
}

TEST_F(PresenceChannelsTest, TellThatSomebodyHasLeft) {
  const Client bob = watcher(), ada = client(), eve = client();
  say(ada, "Ada");
  EXPECT_EQ(bob->heard(), "delta Ada");
  say(eve, "Eve");
  EXPECT_EQ(bob->heard(), "delta Eve");
  channels_.unsubscribed(*ada, "presence/other");
  channels_.unsubscribed(*ada, "document/task");
  channels_.unsubscribed(*ada, "presence/task");
  EXPECT_EQ(bob->heard(), "delta -1");
  channels_.disconnected(*eve);
  EXPECT_EQ(bob->heard(), "delta -2");
}

TEST_F(PresenceChannelsTest, TakeWhoIsSilentAsGone) {
  PresenceChannels impatient(hub_, deadlines_, 1, {.silence = milliseconds(30), .look = milliseconds(5)});
  const Client bob = watcher(), ada = client();
  say(ada, "Ada", impatient);
  EXPECT_EQ(bob->heard(), "delta Ada");
  EXPECT_EQ(bob->heard(), "delta -1");
  say(ada, "Ada", impatient);
  EXPECT_EQ(ada->heard(), "joined 1");
  EXPECT_EQ(ada->heard(), "joined 2") << "they are back";
  deadlines_.close();
}

TEST_F(PresenceChannelsTest, RefuseTheSenderAlone) {
  std::vector<Client> people;
  for (std::size_t i = 0; i <= Presence::kMostPeople; ++i) {
    people.push_back(client());
    say(people.back(), "Ada");
  }
  EXPECT_EQ(people.back()->heard(), "error too_large");
  EXPECT_EQ(people.front()->heard(), "joined 1");
  say(people.front(), "");
  EXPECT_EQ(people.front()->heard(), "error name");
}

}  // namespace
}  // namespace race::server
