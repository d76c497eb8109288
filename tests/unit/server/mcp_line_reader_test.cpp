#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "server/mcp/line_reader.h"

namespace race::server::mcp {
namespace {

// The lines of a text that comes through a pipe; `!` is one that is too long.
std::vector<std::string> lines_of(const std::string& text, std::size_t most) {
  std::array<int, 2> ends{};
  EXPECT_EQ(::pipe(ends.data()), 0);
  std::thread writer([&] {
    for (std::size_t at = 0; at < text.size();) {
      const ssize_t count = ::write(ends[1], text.data() + at, text.size() - at);
      if (count <= 0) break;
      at += static_cast<std::size_t>(count);
    }
    ::close(ends[1]);
  });
  std::vector<std::string> lines;
  LineReader reader(ends[0], most);
  while (const auto line = reader.next()) {
    EXPECT_TRUE(*line || line->error().code == ErrorCode::too_large);
    lines.push_back(*line ? **line : "!");
  }
  EXPECT_FALSE(reader.next());
  writer.join();
  ::close(ends[0]);
  return lines;
}

using Lines = std::vector<std::string>;

TEST(LineReader, GivesEachLineAndWhatFollowsTheLast) {
  EXPECT_EQ(lines_of("", 9), Lines());
  EXPECT_EQ(lines_of("a\n\nbc\n", 9), (Lines{"a", "", "bc"}));
  EXPECT_EQ(lines_of("a\nbc", 9), (Lines{"a", "bc"}));
  EXPECT_EQ(lines_of(std::string("a\0b\n", 4), 9), (Lines{std::string("a\0b", 3)}));
}

TEST(LineReader, WaitsForAFileThatDoesNotWait) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe2(ends.data(), O_NONBLOCK), 0);
  std::thread writer([&] {
    for (const std::string_view text : {"a", "b\nc"}) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      EXPECT_GT(::write(ends[1], text.data(), text.size()), 0);
    }
    ::close(ends[1]);
  });
  LineReader reader(ends[0], 9);
  for (const std::string_view text : {"ab", "c"}) {
    const auto line = reader.next();
    EXPECT_TRUE(line && *line && **line == text) << text;
  }
  EXPECT_FALSE(reader.next());
  writer.join();
  ::close(ends[0]);
}

TEST(LineReader, PassesOverALineThatIsTooLong) {
  EXPECT_EQ(lines_of("123\n1234\n12\n", 3), (Lines{"123", "!", "12"}));
  EXPECT_EQ(lines_of("1234", 3), Lines{"!"});
  const std::string most(300'000, 'x');
  EXPECT_EQ(lines_of(most + "\n" + most + "y\nz\n", most.size()), (Lines{most, "!", "z"}));
  EXPECT_EQ(lines_of(most + most + most + "\nz", most.size()), (Lines{"!", "z"}));
  EXPECT_EQ(lines_of(most + most, most.size()), Lines{"!"});
}

}  // namespace
}  // namespace race::server::mcp
