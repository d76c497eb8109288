#include "services/host/flow_traffic.h"

#include <algorithm>

namespace race::services {
namespace {

template <typename Records>
auto find(Records& records, std::string_view key, std::string_view flow) {
  return std::ranges::find_if(records, [&](const auto& each) { return each.key == key && each.flow == flow; });
}

}  // namespace

bool FlowTraffic::record(std::string_view key, std::string_view flow, const Packet& packet, Time now) {
  constexpr Time kReportPeriod = 1;
  auto record = find(records_, key, flow);
  if (record == records_.end())
    record = records_.insert(records_.end(), {std::string(key), std::string(flow), {}, {}, now});
  record->last = {packet.time, packet.header};
  record->times.push_back(now);
  if (record->times.size() > kCounted) record->times.pop_front();
  if (record->times.size() > 2 && now - record->reported < kReportPeriod) return false;
  record->reported = now;
  return true;
}

Published FlowTraffic::read(std::string_view key, std::string_view flow, Time now) const {
  Published traffic{std::string(flow), 0, 0, {}};
  const auto record = find(records_, key, flow);
  if (record == records_.end()) return traffic;
  traffic.last = record->last;
  if (const Time period = record->period(); period > 0 && !record->has_stopped(now)) traffic.rate_hz = 1 / period;
  return traffic;
}

std::vector<std::string> FlowTraffic::stopped(Time now) {
  std::vector<std::string> keys;
  for (Record& each : records_) {
    if (!each.has_stopped(now)) continue;
    each.times.clear();
    keys.push_back(each.key);
  }
  return keys;
}

void FlowTraffic::reset(std::string_view key, std::optional<std::string_view> flow) {
  std::erase_if(records_, [&](const Record& each) { return each.key == key && (!flow || each.flow == *flow); });
}

Time FlowTraffic::Record::period() const {
  return times.size() < 2 ? 0 : (times.back() - times.front()) / static_cast<double>(times.size() - 1);
}

bool FlowTraffic::Record::has_stopped(Time now) const {
  constexpr Time kTolerance = 1;  // beside three periods
  return period() > 0 && now - times.back() > 3 * period() + kTolerance;
}

}  // namespace race::services
