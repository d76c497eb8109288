// FlowTraffic: how many packets pass on each data flow, and the newest of them.
//
// Threads: one at a time, under the host's lock.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "services/component.h"

namespace race::services {

/// A data flow that a service offers, and what passes on it.
struct Published {
  struct Last {
    Time time = 0;
    Value header;
  };
  std::string flow;
  std::size_t watchers = 0;  // from outside; a service that subscribes says so itself
  double rate_hz = 0;        // packets in a second of the host's clock; 0: none pass
  std::optional<Last> last;  // since the flow has a subscriber
};

class FlowTraffic {
 public:
  /// Counts a packet of the service `key`. Whether what read() says now is worth reporting: at first, then once a
  /// second.
  bool record(std::string_view key, std::string_view flow, const Packet& packet, Time now);
  /// What passes on a flow, but for its watchers. One that has been silent for much longer than its period has stopped.
  Published read(std::string_view key, std::string_view flow, Time now) const;
  /// The services of flows that have stopped since the last call: what was reported of these is out of date.
  std::vector<std::string> stopped(Time now);
  /// Forgets a flow; without `flow`, all of the service.
  void reset(std::string_view key, std::optional<std::string_view> flow = std::nullopt);

 private:
  static constexpr std::size_t kCounted = 10;

  struct Record {
    Time period() const;  // 0: of too few
    bool has_stopped(Time now) const;
    std::string key, flow;
    std::deque<Time> times;  // of the last kCounted since it stopped, as of the host's clock
    Published::Last last;
    Time reported = 0;
  };
  std::vector<Record> records_;
};

}  // namespace race::services
