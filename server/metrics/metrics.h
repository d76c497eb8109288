// Metrics: what the server counts for its operator (GET /metrics): requests by route, and clients; and what it collects
// from others when it is asked.
//
// Threads: any; counting is a few atomic additions and waits for nothing.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "server/metrics/exposition.h"

namespace race::server {

/// How many there are now.
class Gauge {
 public:
  /// One more, until it is destroyed; the gauge outlives it.
  class Hold {
   public:
    explicit Hold(Gauge& gauge) : gauge_(gauge) { ++gauge_.count_; }
    ~Hold() { --gauge_.count_; }
    Hold(const Hold&) = delete;
    Hold& operator=(const Hold&) = delete;

   private:
    Gauge& gauge_;
  };
  std::int64_t count() const { return count_; }

 private:
  std::atomic<std::int64_t> count_{0};
};

/// Who is connected: all connections, those of them that are WebSockets, and those that get events.
struct ClientGauges {
  Gauge connections, streams, controls, processes, events;
};

class Metrics {
 public:
  /// (method, pattern) of each route, whose texts outlive this. Requests for no route are counted as one of their own.
  using Routes = std::vector<std::pair<std::string_view, std::string_view>>;
  using Collector = std::function<void(Exposition&)>;
  /// [s] The last bucket, +Inf, has all.
  static constexpr std::array<double, 8> kBuckets = {0.001, 0.005, 0.025, 0.1, 0.5, 1, 5, 20};

  /// `collect` adds what others know, and outlives this.
  Metrics(const Routes& routes, Collector collect);

  /// A request was answered. `pattern`: of its route; empty: there is none. `time`: from its arrival to its answer.
  void answered(std::string_view method, std::string_view pattern, int status, std::chrono::nanoseconds time);
  /// A password that was wrong, or not looked at because too many were.
  void login_failed() { ++logins_failed_; }
  ClientGauges& clients() { return clients_; }
  /// All of it.
  std::string text() const;

 private:
  static constexpr std::size_t kClasses = 5;  // of status codes: 1xx to 5xx
  struct OfRoute {
    std::array<std::atomic<std::uint64_t>, kClasses> by_class = {};
    std::array<std::atomic<std::uint64_t>, kBuckets.size() + 1> by_time = {};  // each of its own bucket alone
    std::atomic<std::uint64_t> nanoseconds{0};
  };
  void add_requests(Exposition& to) const;
  void add_times(Exposition& to) const;

  std::map<std::pair<std::string_view, std::string_view>, OfRoute> by_route_;  // its keys never change
  std::atomic<std::uint64_t> logins_failed_{0};
  ClientGauges clients_;
  const Collector collect_;
};

}  // namespace race::server
