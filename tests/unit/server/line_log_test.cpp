#include "server/log/line_log.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <array>

#include "core/language/primitives/utf8.h"

namespace race::server {
namespace {

std::string line(std::string_view text, std::string_view component = "server") {
  return log_line(0, LogLevel::info, component, text);
}

TEST(LogLine, HasTimeLevelComponentAndMessage) {
  EXPECT_EQ(log_line(1'795'420'316'007, LogLevel::warning, "core/1", "pick: interrupted"),
            "2026-11-23T07:51:56.007Z warning core/1: pick: interrupted\n");
  EXPECT_EQ(line("größer"), "1970-01-01T00:00:00.000Z info server: größer\n");
}

TEST(LogLine, ATextFromOutsideMakesNoLineAndChangesNoTerminal) {
  const std::string begin = "1970-01-01T00:00:00.000Z info server: ";
  EXPECT_EQ(line("a\n1970-01-01T00:00:00.000Z error server: b\r"),
            begin + R"(a\n1970-01-01T00:00:00.000Z error server: b\u000d)"
                    "\n");
  EXPECT_EQ(line("\x1b[2J\x7f\t"), begin + R"(\u001b[2J\u007f\t)"
                                           "\n");
  EXPECT_EQ(line(R"(a\nb)"), begin + R"(a\\nb)"
                                     "\n")
      << "what was escaped differs from what was there";
  EXPECT_EQ(line("\u0085\u009b\u2028\u202e\u2066"), begin + R"(\u0085\u009b\u2028\u202e\u2066)"
                                                            "\n");
  EXPECT_EQ(line("\xff\nü"), begin + R"(\xff\n\xc3\xbc)"
                                     "\n")
      << "no UTF-8";
  EXPECT_EQ(line("x", "a\nb"), R"(1970-01-01T00:00:00.000Z info a\nb: x)"
                               "\n");
  for (int c = 0; c < 0x20; ++c) {
    const std::string one = line(std::string(1, static_cast<char>(c)));
    EXPECT_EQ(std::ranges::count_if(one, [](char each) { return static_cast<unsigned char>(each) < 0x20; }), 1) << c;
  }
}

TEST(LogLine, IsBounded) {
  const std::size_t place = kMaxLogLine - line("").size();
  EXPECT_EQ(line(std::string(place, 'x')).size(), kMaxLogLine);
  EXPECT_EQ(line(std::string(place, 'x')).find("..."), std::string::npos);
  EXPECT_EQ(line(std::string(place + 1, 'x')).size(), kMaxLogLine);
  EXPECT_THAT(line(std::string(place + 1, 'x')), testing::EndsWith("x...\n"));
  for (const std::string& unit :
       {std::string("x"), std::string("\n"), std::string("\x01"), std::string("ü"), std::string("\xff")}) {
    std::string text = "é";
    while (text.size() < 3 * kMaxLogLine) text += unit;
    const std::string cut = line(text);
    EXPECT_LE(cut.size(), kMaxLogLine);
    EXPECT_GT(cut.size(), kMaxLogLine - 12);
    EXPECT_THAT(cut, testing::EndsWith("...\n"));
    EXPECT_TRUE(language::utf8::valid(cut)) << "no character is cut in two";
  }
  EXPECT_LT(log_line(0, LogLevel::info, std::string(5000, 'c'), "text").size(), 200U);
}

TEST(LogLevels, HaveNames) {
  for (const LogLevel level : {LogLevel::error, LogLevel::warning, LogLevel::info, LogLevel::debug})
    EXPECT_EQ(log_level_of(name(level)), level);
  EXPECT_FALSE(log_level_of("loud") || log_level_of(""));
}

struct LineLogTest : testing::Test {
  LineLogTest() {
    EXPECT_EQ(::pipe2(ends.data(), O_NONBLOCK), 0);
    EXPECT_GE(::fcntl(ends[1], F_SETPIPE_SZ, 4 * 4096), 0);  // four pages
  }
  ~LineLogTest() override {
    for (const int end : ends) ::close(end);
  }
  std::string read_all() const {
    std::string text(1 << 16, ' ');
    const ssize_t got = ::read(ends[0], text.data(), text.size());
    text.resize(got < 0 ? 0 : static_cast<std::size_t>(got));
    return text;
  }

  std::array<int, 2> ends{};
};

TEST_F(LineLogTest, WritesWhatMattersEnough) {
  LineLog log(ends[1], LogLevel::warning);
  log.write(LogLevel::error, "a", "1");
  log.write(LogLevel::warning, "a", "2");
  log.write(LogLevel::info, "a", "3");
  log.write(LogLevel::debug, "a", "4");
  EXPECT_THAT(read_all(), testing::MatchesRegex("[^\n]* error a: 1\n[^\n]* warning a: 2\n"));
}

TEST_F(LineLogTest, WaitsForNoReaderAndCountsWhatItDrops) {
  LineLog log(ends[1], LogLevel::info);
  for (int i = 0; i < 100; ++i) log.write(LogLevel::info, "a", std::string(500, 'x'));  // would wait in a full pipe
  std::string before;
  for (std::string part = read_all(); !part.empty(); part = read_all()) before += part;
  const auto kept = std::ranges::count(before, '\n');
  EXPECT_LT(kept, 100);
  log.write(LogLevel::info, "a", "last");
  EXPECT_THAT(read_all(), testing::MatchesRegex("[^\n]* warning log: " + std::to_string(100 - kept) +
                                                " lines had no place[^\n]*\n[^\n]* info a: last\n"));
}

TEST_F(LineLogTest, AReaderThatHasGoneEndsNothing) {
  ::close(std::exchange(ends[0], -1));
  LineLog log(ends[1], LogLevel::info);
  log.write(LogLevel::info, "a", "no SIGPIPE");
  LineLog none(-1, LogLevel::info);
  none.write(LogLevel::info, "a", "no descriptor");
}

}  // namespace
}  // namespace race::server
