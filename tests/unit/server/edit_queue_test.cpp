// Edits of the stream: who is told what, in which order, and how many wait.
#include "server/editing/edit_queue.h"

#include <gmock/gmock.h>

#include "server/wire/channel_names.h"
#include "server/wire/path_pattern.h"
#include "tests/unit/server/bench.h"
#include "tests/unit/server/boxed_subscriber.h"
#include "tests/unit/server/edited_document.h"

namespace race::server {
namespace {

using std::chrono::milliseconds;
using testing::ElementsAre;

struct EditingClient final : BoxedSubscriber {
  /// What came since: "snapshot", "delta t-1", "edit_refused t-1 unavailable", "error name".
  std::vector<std::string> received() {
    std::vector<std::string> out;
    for (const Value& message : messages()) {
      const Value& data = *message.find("data");
      const Value* token = data.find("request");
      const Value* errors = data.find("errors");
      out.push_back(message.find("kind")->as_string() + (token ? " " + token->as_string() : "") +
                    (errors && !errors->as_list().empty() ? " " + errors->as_list()[0].find("code")->as_string() : ""));
    }
    return out;
  }
};

struct NoWatcher final : DocumentWatcher {
  void document_changed(const std::string&, std::int64_t, bool) override {}
};

/// As DocumentPublisher of server/channels.
struct Publisher final : EditPublisher {
  explicit Publisher(Hub& to) : hub(to) {}
  static std::string channel(const std::string& document) { return fill(kDocumentChannel, {document}); }
  void edited(const std::string& document, Value accepted) override {
    hub.publish_delta(channel(document), std::move(accepted));
  }
  void replaced(const std::string&, Value) override {}
  void shown(const std::string& document, Value snapshot) override {
    hub.publish_snapshot(channel(document), std::move(snapshot));
  }
  void ended(const std::string& document, std::vector<Error> errors) override {
    hub.close(channel(document), std::move(errors));
  }
  void all_replaced() override {}
  Hub& hub;
};

class EditQueueTest : public DocumentStore {
 protected:
  EditQueueTest() { documents_->put("task", kWithIds).value(); }
  ~EditQueueTest() override {
    hub_.shut_down();  // it asks the queue for nothing more
    queue_.reset();
    hub_.shut_down();  // and has done what the queue said last
  }

  std::optional<Source> source(const std::string& name) {
    if (!name.starts_with("document/")) return std::nullopt;
    return Source{false, [this, name] { queue_->request_snapshot(name.substr(9)); }, {}};
  }
  void ask(const std::string& token, const std::string& more = R"("operations": [])") {
    queue_->request_edit(client_, parse_json(R"({"type": "edit", "document": "task", "revision": 1, "request": ")" +
                                             token + "\", " + more + "}")
                                      .value());
  }
  void subscribe() {
    hub_.subscribe(client_, fill(kDocumentChannel, {"task"}), {});
    EXPECT_THAT(received(1), ElementsAre("snapshot"));
  }
  /// Waits for as many messages.
  std::vector<std::string> received(std::size_t count) {
    std::vector<std::string> out;
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (out.size() < count && std::chrono::steady_clock::now() < end) {
      std::this_thread::sleep_for(milliseconds(1));
      for (std::string& each : client_->received()) out.push_back(std::move(each));
    }
    return out;
  }

  static constexpr std::size_t kMost = 3;
  std::unique_ptr<Documents> documents_ = open();
  NoWatcher watcher_;
  Pool pool_{1};
  Hub hub_{pool_, 1000, [this](const std::string& name) { return source(name); }};
  NoRecords records_;
  Publisher publisher_{hub_};
  Editing editing_{*documents_, publisher_, watcher_};
  std::shared_ptr<EditingClient> client_ = std::make_shared<EditingClient>();
  std::optional<EditQueue> queue_{std::in_place, editing_, hub_, records_, kMost};
};

TEST_F(EditQueueTest, TellsASubscriberByTheDeltaAndOthersByAMessage) {
  ask("t-1");
  EXPECT_THAT(received(1), ElementsAre("edit_accepted t-1"));
  subscribe();
  ask("t-2");
  EXPECT_THAT(received(1), ElementsAre("delta t-2"));
  ask("t-1");
  EXPECT_THAT(received(1), ElementsAre("edit_accepted t-1")) << "it was there";
  ask("t-3", R"("undo": true)");
  ask("t-4", R"("undo": true)");
  ask("t-5", R"("undo": true)");
  EXPECT_THAT(received(3), ElementsAre("delta t-3", "delta t-4", "edit_refused t-5 not_found"));
}

TEST_F(EditQueueTest, RefusesWhatItCannotReadByTheTokenIfThereIsOne) {
  ask("t-1", R"("more": 1, "undo": true)");
  ask("t-2", R"("operations": [{"op": "burn"}])");
  ask("a b");
  EXPECT_THAT(received(3), ElementsAre("edit_refused t-1 unknown_field", "edit_refused t-2 name", "error name"));
  EXPECT_EQ(documents_->entry("task")->revision.number, 1);
}

TEST_F(EditQueueTest, KeepsSoManyEditsAndRefusesTheOthersAtOnce) {
  std::size_t refused = 0;
  {
    const auto pause = editing_.pause();
    ASSERT_TRUE(pause);
    for (std::size_t i = 0; i < 20; ++i) ask("t-" + std::to_string(i));
    // One may be under way, so as many wait, or one less.
    for (const std::string& message : received(20 - kMost - 1)) {
      EXPECT_THAT(message, testing::EndsWith(" unavailable"));
      ++refused;
    }
    EXPECT_GE(refused, 20 - kMost - 1);
    EXPECT_LE(refused, 20 - kMost);
  }
  EXPECT_EQ(received(20 - refused).size(), 20 - refused);
  EXPECT_EQ(documents_->entry("task")->revision.number, static_cast<std::int64_t>(21 - refused));
  ask("t-19");
  EXPECT_THAT(received(1), ElementsAre("edit_accepted t-19")) << "it is sent again";
}

TEST_F(EditQueueTest, KeepsSoManyDocumentsThatAreWanted) {
  const auto pause = editing_.pause();
  const auto want = [this](int i) { hub_.subscribe(client_, "document/d-" + std::to_string(i), {}); };
  for (int i = 0; i < 20; ++i) want(i);
  // One may be under way.
  const auto ended = received(20 - kMost - 1);
  EXPECT_GE(ended.size(), 20 - kMost - 1);
  EXPECT_THAT(ended, testing::Each("error unavailable"));
  for (int i = 0; i < 10; ++i) queue_->request_snapshot("d-1");
  std::this_thread::sleep_for(milliseconds(20));
  EXPECT_LE(client_->received().size(), 1U) << "it is wanted already";
}

TEST_F(EditQueueTest, DropsWhatWaitsWhenItStops) {
  {
    const auto pause = editing_.pause();
    for (std::size_t i = 0; i < kMost; ++i) ask("t-" + std::to_string(i));
    queue_->stop();
  }
  ask("t-9");
  EXPECT_THAT(received(1), testing::Contains("edit_refused t-9 unavailable"));
  queue_.reset();  // once its thread has come to an end
  EXPECT_LE(documents_->entry("task")->revision.number, 2) << "one may have been under way";
}

}  // namespace
}  // namespace race::server
