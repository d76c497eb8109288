#include "server/metrics/metrics.h"

#include <algorithm>
#include <limits>

namespace race::server {
namespace {

constexpr std::pair<std::string_view, std::string_view> kOther = {"other", "other"};
constexpr std::array<std::string_view, 5> kCodes = {"1xx", "2xx", "3xx", "4xx", "5xx"};

double of(std::uint64_t count) { return static_cast<double>(count); }
double of(std::int64_t count) { return static_cast<double>(count); }

std::string bound_text(double bound) {
  std::string text = std::to_string(bound);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace

Metrics::Metrics(const Routes& routes, Collector collect) : collect_(std::move(collect)) {
  for (const auto& route : routes) by_route_[route];
  by_route_[kOther];
}

void Metrics::answered(std::string_view method, std::string_view pattern, int status, std::chrono::nanoseconds time) {
  auto route = by_route_.find({method, pattern});
  if (route == by_route_.end()) route = by_route_.find(kOther);
  OfRoute& counts = route->second;
  ++counts.by_class[static_cast<std::size_t>(std::clamp(status / 100, 1, 5) - 1)];
  const double seconds = std::chrono::duration<double>(time).count();
  ++counts.by_time[static_cast<std::size_t>(std::ranges::lower_bound(kBuckets, seconds) - kBuckets.begin())];
  counts.nanoseconds += static_cast<std::uint64_t>(std::max<std::int64_t>(time.count(), 0));
}

void Metrics::add_requests(Exposition& to) const {
  constexpr std::string_view kName = "race_http_requests_total";
  to.family(kName, "counter", "Requests that were answered, by route and class of status; other: of no route.");
  for (const auto& [route, counts] : by_route_)
    for (std::size_t code = 0; code < kClasses; ++code)
      if (const std::uint64_t count = counts.by_class[code]; count > 0)
        to.sample(kName, {{"method", route.first}, {"route", route.second}, {"code", kCodes[code]}}, of(count));
}

// The sum of the buckets is the count, whatever is counted meanwhile.
void Metrics::add_times(Exposition& to) const {
  const std::string name = "race_http_request_duration_seconds";
  to.family(name, "histogram", "From the arrival of a request to its answer, without sending it.");
  for (const auto& [route, counts] : by_route_) {
    const double sum = of(counts.nanoseconds.load()) * 1e-9;
    std::uint64_t count = 0;
    std::array<std::uint64_t, kBuckets.size() + 1> up_to = {};
    for (std::size_t i = 0; i < up_to.size(); ++i) up_to[i] = count += counts.by_time[i];
    if (count == 0) continue;
    for (std::size_t i = 0; i < up_to.size(); ++i) {
      const std::string bound = i < kBuckets.size() ? bound_text(kBuckets[i]) : "+Inf";
      to.sample(name + "_bucket", {{"method", route.first}, {"route", route.second}, {"le", bound}}, of(up_to[i]));
    }
    to.sample(name + "_sum", {{"method", route.first}, {"route", route.second}}, sum);
    to.sample(name + "_count", {{"method", route.first}, {"route", route.second}}, of(count));
  }
}

std::string Metrics::text() const {
  Exposition to;
  add_requests(to);
  add_times(to);
  to.single("race_logins_failed_total", "counter", "Logins with a wrong password or code, or refused after too many.",
            of(logins_failed_.load()));
  to.single("race_connections", "gauge", "Connections of clients now, WebSockets too.",
            of(clients_.connections.count()));
  constexpr std::string_view kSockets = "race_websockets";
  to.family(kSockets, "gauge",
            "WebSockets now: clients of the stream, people at the controls, processes of components.");
  to.sample(kSockets, {{"kind", "stream"}}, of(clients_.streams.count()));
  to.sample(kSockets, {{"kind", "control"}}, of(clients_.controls.count()));
  to.sample(kSockets, {{"kind", "components"}}, of(clients_.processes.count()));
  to.single("race_event_streams", "gauge", "Answers now that go on: Server-Sent Events.", of(clients_.events.count()));
  collect_(to);
  return to.text();
}

}  // namespace race::server
