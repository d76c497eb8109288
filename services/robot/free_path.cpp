#include "services/robot/free_path.h"

#include <algorithm>
#include <cmath>

namespace race::robot {
namespace {

constexpr double kStep = 0.4;       // rad, that a tree grows by
constexpr int kShortcuts = 60;      // attempts
constexpr int kSmoothings = 5;      // attempts, each with half the rounding of the one before
constexpr int kWidestRounding = 8;  // places, each side

double distance(const Joints& a, const Joints& b) {
  double sum = 0;
  for (std::size_t i = 0; i < kJoints; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

Joints between(const Joints& from, const Joints& to, double share) {
  Joints q;
  for (std::size_t i = 0; i < kJoints; ++i) q[i] = from[i] + share * (to[i] - from[i]);
  return q;
}

/// Uniform in [0, 1): the standard's distributions differ from library to library.
double uniform(std::mt19937& random) { return static_cast<double>(random()) / 4294967296.0; }

std::vector<Joints> evenly_spaced(const std::vector<Joints>& corners, double spacing) {
  double length = 0;
  for (std::size_t i = 1; i < corners.size(); ++i) length += distance(corners[i - 1], corners[i]);
  const int count = std::max(1, static_cast<int>(std::ceil(length / spacing)));
  std::vector<Joints> places{corners.front()};
  std::size_t segment = 1;
  double passed = 0;  // length before the segment
  for (int k = 1; k < count; ++k) {
    const double at = length * k / count;
    while (passed + distance(corners[segment - 1], corners[segment]) < at && segment + 1 < corners.size()) {
      passed += distance(corners[segment - 1], corners[segment]);
      ++segment;
    }
    const double size = distance(corners[segment - 1], corners[segment]);
    places.push_back(between(corners[segment - 1], corners[segment], size > 0 ? (at - passed) / size : 1.0));
  }
  places.push_back(corners.back());
  return places;
}

/// Means over up to `half` neighbours on each side, fewer near the ends, which stay.
std::vector<Joints> rounded(const std::vector<Joints>& places, std::size_t half) {
  std::vector<Joints> out = places;
  for (std::size_t k = 1; k + 1 < places.size(); ++k) {
    const std::size_t reach = std::min({half, k, places.size() - 1 - k});
    Joints sum{};
    for (std::size_t j = k - reach; j <= k + reach; ++j) {
      for (std::size_t i = 0; i < kJoints; ++i) sum[i] += places[j][i];
    }
    for (std::size_t i = 0; i < kJoints; ++i) out[k][i] = sum[i] / static_cast<double>(2 * reach + 1);
  }
  return out;
}

}  // namespace

FreePath::FreePath(const JointLimits& limits, Allowed allowed, const Joints& start, const Joints& goal, unsigned seed)
    : limits_(limits), allowed_(std::move(allowed)), random_(seed), trees_{Tree{{start}}, Tree{{goal}}} {}

FreePath::State FreePath::work(int checks) {
  const int until = checks_ + checks;
  if (checks_ == 0 && free_between(trees_[0][0].q, trees_[1][0].q)) join(0, 0);
  while (state_ == State::searching && checks_ < until) {
    if (checks_ > kMostChecks) {
      state_ = State::failed;
    } else if (corners_.empty()) {
      grow();
    } else if (corners_.size() > 2 && shortcuts_ < kShortcuts) {
      shorten();
    } else {
      smooth();
    }
  }
  return state_;
}

bool FreePath::check(const Joints& q) {
  ++checks_;
  return allowed_(q);
}

bool FreePath::free_between(const Joints& from, const Joints& to) {
  const int count = std::max(1, static_cast<int>(std::ceil(distance(from, to) / kResolution)));
  for (int k = 1; k <= count; ++k) {
    if (!check(between(from, to, static_cast<double>(k) / count))) return false;
  }
  return true;
}

Joints FreePath::sample() {
  Joints q;
  for (std::size_t i = 0; i < kJoints; ++i)
    q[i] = limits_.lower[i] + uniform(random_) * (limits_.upper[i] - limits_.lower[i]);
  return q;
}

std::optional<int> FreePath::extend(Tree& tree, const Joints& target) {
  const auto nearest = std::min_element(tree.begin(), tree.end(), [&](const Node& a, const Node& b) {
    return distance(a.q, target) < distance(b.q, target);
  });
  const double way = distance(nearest->q, target);
  const Joints next = way > kStep ? between(nearest->q, target, kStep / way) : target;
  if (!free_between(nearest->q, next)) return std::nullopt;
  tree.push_back({next, static_cast<int>(nearest - tree.begin())});
  return static_cast<int>(tree.size()) - 1;
}

void FreePath::grow() {
  Tree& tree = trees_[turn_];
  Tree& other = trees_[1 - turn_];
  if (const auto reached = extend(tree, sample())) {
    const Joints target = tree[static_cast<std::size_t>(*reached)].q;
    for (auto node = extend(other, target); node; node = extend(other, target)) {
      if (other[static_cast<std::size_t>(*node)].q != target) continue;
      join(turn_ == 0 ? *reached : *node, turn_ == 0 ? *node : *reached);
      return;
    }
  }
  turn_ = 1 - turn_;
}

void FreePath::join(int in_first, int in_second) {
  for (int node = in_first; node >= 0; node = trees_[0][static_cast<std::size_t>(node)].parent)
    corners_.insert(corners_.begin(), trees_[0][static_cast<std::size_t>(node)].q);
  // Both trees have the place where they meet; a direct way has none.
  if (in_first == 0 && in_second == 0) {
    corners_.push_back(trees_[1][0].q);
    return;
  }
  for (int node = trees_[1][static_cast<std::size_t>(in_second)].parent; node >= 0;
       node = trees_[1][static_cast<std::size_t>(node)].parent)
    corners_.push_back(trees_[1][static_cast<std::size_t>(node)].q);
}

void FreePath::shorten() {
  ++shortcuts_;
  const auto last = static_cast<double>(corners_.size() - 1);
  double a = uniform(random_) * last;
  double b = uniform(random_) * last;
  if (a > b) std::swap(a, b);
  const auto first = static_cast<std::size_t>(a);
  const auto second = std::min(static_cast<std::size_t>(b), corners_.size() - 2);
  if (first >= second) return;
  const Joints from = between(corners_[first], corners_[first + 1], a - static_cast<double>(first));
  const Joints to = between(corners_[second], corners_[second + 1], b - static_cast<double>(second));
  if (!free_between(from, to)) return;
  corners_.erase(corners_.begin() + static_cast<std::ptrdiff_t>(first) + 1,
                 corners_.begin() + static_cast<std::ptrdiff_t>(second) + 1);
  corners_.insert(corners_.begin() + static_cast<std::ptrdiff_t>(first) + 1, {from, to});
}

void FreePath::smooth() {
  const std::vector<Joints> exact = evenly_spaced(corners_, kResolution);
  std::size_t half = kWidestRounding;
  for (int attempt = 0; attempt < kSmoothings && checks_ <= kMostChecks; ++attempt, half /= 2) {
    // Twice: the mean of a corner has an edge, the mean of that has none.
    places_ = rounded(rounded(exact, half), half);
    if (std::all_of(places_.begin(), places_.end(), [&](const Joints& q) { return check(q); })) {
      state_ = State::found;
      return;
    }
  }
  // A place between those that were checked is too near to something: search another way.
  corners_.clear();
  trees_[0].resize(1);
  trees_[1].resize(1);
  shortcuts_ = 0;
}

}  // namespace race::robot
