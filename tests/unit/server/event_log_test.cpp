#include "server/log/event_log.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <array>

#include "core/value/json.h"
#include "tests/unit/server/boxed_subscriber.h"

namespace race::server {
namespace {

struct EventLogTest : testing::Test {
  // The entries of a snapshot: "source: text".
  std::vector<std::string> entries() {
    const auto client = std::make_shared<BoxedSubscriber>();
    hub.subscribe(client, "log", {});
    std::optional<Text> text;
    while (!text) {  // the hub and the snapshot take their turns on the strand
      Strand(pool).ask([] { return 0; });
      text = client->box.pop();
    }
    hub.shut_down();  // waits until the hub has nothing left to do
    std::vector<std::string> lines;
    const Value message = parse_json((*text)->json).value();
    for (const Value& entry : message.find("data")->find("entries")->as_list())
      lines.push_back(entry.find("source")->as_string() + ": " + entry.find("text")->as_string());
    return lines;
  }
  static Value core(const std::string& status) { return Dict{{"document", "pick"}, {"status", status}}; }

  Pool pool{1};
  Hub hub{pool, 1, [this](const std::string&) { return Source{false, [this] { log.publish_snapshot(); }, {}}; }};
  EventLog log{hub};
};

TEST_F(EventLogTest, KeepsTheLastEntries) {
  for (std::size_t i = 0; i < EventLog::kMaxEntries + 5; ++i) log.append(0, "server", std::to_string(i));
  const auto lines = entries();
  EXPECT_EQ(lines.size(), EventLog::kMaxEntries);
  EXPECT_EQ(lines.front(), "server: 5");
}

TEST_F(EventLogTest, CutsLongTexts) {
  log.append(0, "s", std::string(2 * EventLog::kMaxText, 'x'));
  EXPECT_EQ(entries().front().size(), EventLog::kMaxText + 3);
}

TEST_F(EventLogTest, LogsAStatusOnlyWhenItChanges) {
  EXPECT_TRUE(log.append_status(0, "1", core("ready")));
  EXPECT_TRUE(log.append_status(0, "1", core("running")));
  EXPECT_FALSE(log.append_status(0, "1", core("running")));
  EXPECT_TRUE(log.append_status(0, "2", core("running")));
  EXPECT_THAT(entries(), testing::ElementsAre("core/1: pick: ready", "core/1: pick: running", "core/2: pick: running"));
}

TEST_F(EventLogTest, RemembersABoundedNumberOfStatuses) {
  const std::size_t most = EventLog::kMaxStatuses;
  for (std::size_t i = 0; i <= most; ++i) log.append_status(0, std::to_string(1'000'000 + i), core("ready"));
  EXPECT_TRUE(log.append_status(0, "1000000", core("ready"))) << "it was forgotten";
  EXPECT_FALSE(log.append_status(0, std::to_string(1'000'000 + most), core("ready")));
}

TEST_F(EventLogTest, CutsALongLineBetweenCharacters) {
  log.append(0, "timer", std::string(EventLog::kMaxText - 1, 'x') + "é");
  EXPECT_THAT(entries(), testing::ElementsAre("timer: " + std::string(EventLog::kMaxText - 1, 'x')));
}

TEST_F(EventLogTest, EscapesWhatIsNoUtf8) {
  log.append(0, "a\xff", "cannot open \xc3\x28: \n");
  EXPECT_THAT(entries(), testing::ElementsAre("a\\xff: cannot open \\xc3(: \n"));
}

TEST(EventLog, WritesItsLinesByLevel) {
  Pool pool{1};
  Hub hub{pool, 1, [](const std::string&) { return std::nullopt; }};
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  LineLog lines(ends[1], LogLevel::debug);
  EventLog log(hub, &lines);
  log.append(0, "timer", "available");
  for (const char* status : {"running", "interrupted", "faulted"})
    log.append_status(0, "1", Dict{{"document", "pick"}, {"status", status}});
  ::close(ends[1]);
  std::string text(4096, ' ');
  text.resize(static_cast<std::size_t>(::read(ends[0], text.data(), text.size())));
  ::close(ends[0]);
  EXPECT_THAT(text,
              testing::ContainsRegex("info timer: available\n.* info core/1: pick: running\n.* warning core/1: pick: "
                                     "interrupted\n.* error core/1: pick: faulted\n"));
}

}  // namespace
}  // namespace race::server
