// The yardstick: a minimal table-driven machine. Flat tables, guards as one comparison, no formal rules, no language,
// no values but doubles. What the same work costs when nothing else is asked for.
#pragma once

#include <cstdint>
#include <vector>

namespace race::bench {

class TableMachine {
 public:
  struct Row {  // one state
    std::int32_t parent = -1;
    double above = 0;  // its guard: payload > above
    std::int32_t to = -1;
  };

  static TableMachine ring(int count) {
    TableMachine m;
    for (int i = 0; i < count; ++i) m.rows_.push_back({-1, 0, (i + 1) % count});
    m.active_ = {0};
    return m;
  }
  static TableMachine deep(int depth) {
    TableMachine m;
    for (int i = 0; i < depth; ++i) m.rows_.push_back({i - 1, 1e300, -1});
    m.rows_.push_back({depth - 1, 0, depth + 1});
    m.rows_.push_back({depth - 1, 0, depth});
    m.active_ = {depth};
    return m;
  }
  static TableMachine concurrent(int count) {
    TableMachine m;
    for (int i = 0; i < count; ++i) {
      m.rows_.push_back({-1, 0, count + i});  // waits at the barrier
      m.active_.push_back(i);
    }
    for (int i = 0; i < count; ++i) m.rows_.push_back({-1, 1e300, -1});
    m.barrier_ = count;
    return m;
  }

  void event(double payload) {
    for (std::int32_t& s : active_) {
      std::int32_t stop = -1;  // the outermost ancestor whose guard holds would preempt
      for (std::int32_t a = rows_[static_cast<std::size_t>(s)].parent; a >= 0;
           a = rows_[static_cast<std::size_t>(a)].parent)
        if (payload > rows_[static_cast<std::size_t>(a)].above) stop = a;
      const Row& row = rows_[static_cast<std::size_t>(s)];
      if (stop < 0 && payload > row.above) {
        s = row.to;
        ++arrived_;
      }
    }
    if (barrier_ > 0 && arrived_ >= barrier_) {
      for (int i = 0; i < barrier_; ++i) active_[static_cast<std::size_t>(i)] = i;
      arrived_ = 0;
    }
  }
  std::int32_t state() const { return active_[0]; }

 private:
  std::vector<Row> rows_;
  std::vector<std::int32_t> active_;
  std::int32_t barrier_ = 0, arrived_ = 0;
};

/// An action that adds the payload, and a guard on the sum.
class TableSum {
 public:
  void event(double payload) {
    sum_ += payload;
    if (sum_ < 0) ended_ = true;
  }
  double sum() const { return ended_ ? 0 : sum_; }

 private:
  double sum_ = 0;
  bool ended_ = false;
};

}  // namespace race::bench
