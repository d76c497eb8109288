// The tables that services/robot/README.md has under 'Measured', row by row, and what its reader concludes from them.
// The simulation is deterministic, but another compiler may round differently: figures may differ by 10 %, and 2 N or
// 1 ms.
#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <map>
#include <ostream>

#include "tests/bench/robot/collision.h"

namespace race::robot {

static void PrintTo(const Clamping& row, std::ostream* out) { *out << row.mode << ", " << row.reaction_name(); }

namespace {

using Cells = std::vector<std::string>;

/// `| a | b |` as {"a", "b"}.
Cells split(const std::string& line) {
  Cells cells;
  for (std::size_t from = 2; from < line.size();) {
    const std::size_t to = std::min(line.find(" |", from), line.size());
    cells.push_back(line.substr(from, to - from));
    from = to + 3;
  }
  return cells;
}

/// The rows of the README's table whose head begins with this.
std::vector<Cells> table(const std::string& head) {
  std::ifstream readme(RACE_SOURCE_DIR "/services/robot/README.md");
  std::vector<Cells> rows;
  std::string line;
  while (std::getline(readme, line) && !line.starts_with(head)) {
  }
  std::getline(readme, line);  // the rule below the head
  while (std::getline(readme, line) && line.starts_with("|")) rows.push_back(split(line));
  return rows;
}

std::vector<Cells> detections() { return table("| speed, m/s | contact to threshold, ms |"); }
std::vector<Cells> forces() { return table("| mode | on a collision |"); }

/// Equal but for rounding: within 10 % and `unit` of what is written.
testing::Matcher<double> IsWritten(const std::string& written, double unit) {
  const double number = std::stod(written);
  return testing::DoubleNear(number, 0.1 * number + unit);
}

/// clamp(), once for each row and speed.
const ClampForce& measured(const Clamping& row, double speed) {
  static std::map<std::tuple<std::string, std::string, double>, ClampForce> known;
  const auto key = std::tuple(row.mode, row.reaction_name(), speed);
  if (!known.contains(key)) known[key] = clamp(row.behavior, speed);
  return known[key];
}

/// Whether the arm does not go on with its motion.
bool stops(const Clamping& row) { return row.reaction && *row.reaction != Reaction::slow_down; }

TEST(Measured, DetectionsHaveARowForEachSpeed) {
  const std::vector<Cells> rows = detections();
  ASSERT_EQ(rows.size(), kDetectionSpeeds.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), 5U);
    EXPECT_DOUBLE_EQ(std::stod(rows[i][0]), kDetectionSpeeds[i]);
  }
}

TEST(Measured, ForcesHaveARowForEachModeAndReaction) {
  const std::vector<Cells> rows = forces();
  const std::vector<Clamping> expected = clampings();
  ASSERT_EQ(rows.size(), expected.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), 6U);
    EXPECT_EQ(rows[i][0], expected[i].mode);
    EXPECT_EQ(rows[i][1], expected[i].reaction_name());
  }
}

class MeasuredDetection : public testing::TestWithParam<std::size_t> {};

TEST_P(MeasuredDetection, IsAsWritten) {
  const Cells written = detections().at(GetParam());
  const Detection found = detect(kDetectionSpeeds[GetParam()]);
  EXPECT_THAT(found.to_threshold, IsWritten(written.at(1), 1));
  EXPECT_THAT(found.to_command, IsWritten(written.at(2), 1));
  EXPECT_GE(found.to_command, 0) << "the reflex answers a residual above its threshold";
  EXPECT_LT(found.to_command, 2.5) << "two cycles are allowed";
  EXPECT_EQ(name(found.at_once), written.at(3));
  EXPECT_EQ(name(found.worst), written.at(4));
}

INSTANTIATE_TEST_SUITE_P(Speeds, MeasuredDetection, testing::Range(std::size_t{0}, kDetectionSpeeds.size()),
                         [](const auto& info) {
                           return std::to_string(std::lround(1000 * kDetectionSpeeds[info.param])) + "_mm_per_s";
                         });

class MeasuredForce : public testing::TestWithParam<Clamping> {};

TEST_P(MeasuredForce, IsAsWritten) {
  const Clamping& row = GetParam();
  for (const Cells& written : forces()) {
    if (written.at(0) != row.mode || written.at(1) != row.reaction_name()) continue;
    for (std::size_t i = 0; i < kClampSpeeds.size(); ++i) {
      const ClampForce& force = measured(row, kClampSpeeds[i]);
      EXPECT_THAT(force.peak, IsWritten(written.at(2 + 2 * i), 2)) << "N, peak at " << kClampSpeeds[i] << " m/s";
      EXPECT_THAT(force.after, IsWritten(written.at(3 + 2 * i), 2)) << "N, 2 s after " << kClampSpeeds[i] << " m/s";
    }
    return;
  }
  FAIL() << "the table has no such row";
}

INSTANTIATE_TEST_SUITE_P(Rows, MeasuredForce, testing::ValuesIn(clampings()), [](const auto& info) {
  std::string id = info.param.mode + "_" + info.param.reaction_name();
  std::erase_if(id, [](unsigned char c) { return c != '_' && c != ' ' && !std::isalnum(c); });
  std::replace(id.begin(), id.end(), ' ', '_');
  return id;
});

TEST(Measured, AStoppingReactionAtLeastHalvesThePeakOfACompliantArm) {
  const std::vector<Clamping> rows = clampings();
  int compared = 0;
  for (const Clamping& row : rows) {
    const Mode mode = row.behavior.operational.mode;
    if (!stops(row) || (mode != Mode::joint_impedance && mode != Mode::cartesian_impedance)) continue;
    const auto without = std::find_if(rows.begin(), rows.end(),
                                      [&](const Clamping& other) { return other.mode == row.mode && !other.reaction; });
    ASSERT_NE(without, rows.end());
    for (const double speed : kClampSpeeds) {
      EXPECT_LT(measured(row, speed).peak, 0.5 * measured(*without, speed).peak)
          << row.mode << ", " << row.reaction_name() << " at " << speed << " m/s";
      ++compared;
    }
  }
  EXPECT_EQ(compared, 2 * 3 * 2) << "modes, reactions, speeds";
}

TEST(Measured, AStoppingReactionKeepsBelowThePublishedForces) {
  int compared = 0;
  for (const Clamping& row : clampings()) {
    if (!stops(row)) continue;
    for (const double speed : kClampSpeeds) {
      const ClampForce& force = measured(row, speed);
      const std::string which = row.mode + ", " + row.reaction_name() + " at " + std::to_string(speed) + " m/s";
      EXPECT_LT(force.peak, kTransient) << which;
      EXPECT_LT(force.after, kQuasiStatic) << which;
      ++compared;
    }
  }
  EXPECT_EQ(compared, (3 * 3 + 1) * 2) << "modes and reactions, led by hand; speeds";
}

}  // namespace
}  // namespace race::robot
