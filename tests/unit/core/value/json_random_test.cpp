// Random values survive writing and reading; damaged texts are refused or read as a value that survives it too.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>
#include <string>

#include "core/value/json.h"

namespace race {
namespace {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  std::size_t below(std::size_t n) { return static_cast<std::size_t>(engine_() % n); }

  Value value(int levels) {
    switch (below(levels > 0 ? 8 : 5)) {
      case 0:
        return {};
      case 1:
        return below(2) == 1;
      case 2:
        return static_cast<std::int64_t>(engine_()) >> below(64);
      case 3:
        return number();
      case 4:
        return text();
      case 5:
      case 6: {
        List items;
        for (std::size_t n = below(5); n > 0; --n) items.push_back(value(levels - 1));
        return items;
      }
      default: {
        Dict entries;
        for (std::size_t n = below(20); n > 0; --n) entries.set(text(), value(levels - 1));
        return entries;
      }
    }
  }

 private:
  // Any finite double: every exponent is as likely as any other.
  double number() {
    const auto v = std::bit_cast<double>(engine_());
    return std::isfinite(v) ? v : 0.5;
  }
  std::string text() {
    static constexpr const char* kPieces[] = {"a", "Z", "\"", "\\", "\n", "\x01", "/", "é", "\u2028", "😀", " ", "0"};
    std::string out;
    for (std::size_t n = below(8); n > 0; --n) out += kPieces[below(std::size(kPieces))];
    return out;
  }

  std::mt19937_64 engine_;
};

TEST(JsonRoundTrip, RandomValuesReadBackTheSame) {
  const std::uint64_t seed = 1;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (int i = 0; i < 3000; ++i) {
    const Value value = random.value(5);
    for (const int indent : {-1, 2}) {
      const std::string text = to_json(value, indent);
      const auto read = parse_json(text);
      ASSERT_TRUE(read) << text << ": " << read.error().message;
      ASSERT_EQ(*read, value) << text;
      ASSERT_EQ(to_json(*read, indent), text) << "the order of entries is part of the text";
    }
  }
}

TEST(JsonRoundTrip, DamagedTextIsRefusedOrReadsBackTheSame) {
  const std::uint64_t seed = 2;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  int refused = 0;
  int accepted = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string text = to_json(random.value(3));
    for (std::size_t n = 1 + random.below(3); n > 0 && !text.empty(); --n) {
      const std::size_t at = random.below(text.size());
      if (random.below(3) == 0) {
        text.erase(at, 1);
      } else if (random.below(2) == 0) {
        text.insert(at, 1, "[]{}\",:0-e.\\"[random.below(12)]);
      } else {
        text[at] = static_cast<char>(random.below(256));
      }
    }
    const auto read = parse_json(text);
    if (!read) {
      ++refused;
      continue;
    }
    ++accepted;
    const auto again = parse_json(to_json(*read));
    ASSERT_TRUE(again) << text;
    ASSERT_EQ(*again, *read) << text;
  }
  EXPECT_GT(refused, 1000);
  EXPECT_GT(accepted, 1000);
}

}  // namespace
}  // namespace race
