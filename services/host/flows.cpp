#include "services/host/flows.h"

#include <algorithm>

namespace race::services {
namespace {

bool is_of(const Flows::Subscription& each, std::string_view key, std::string_view flow) {
  return each.key == key && each.flow == flow;
}

bool is_service(const Flows::Subscription& each, std::size_t service) {
  return each.watch == 0 && each.service == service;
}

}  // namespace

std::vector<std::string> offered(const rsm::Service& model) {
  std::vector<std::string> names;
  const Value* flows = model.meta.find("flows");
  if (!flows || !flows->is_dict()) return names;
  for (const auto& [name, text] : flows->as_dict()) names.push_back(name.as_string());
  return names;
}

bool Flows::has_demand(std::string_view key, std::string_view flow) const {
  return std::ranges::any_of(subscriptions_, [&](const Subscription& each) { return is_of(each, key, flow); });
}

bool Flows::is_subscribed(std::size_t service, std::string_view key, std::string_view flow) const {
  return std::ranges::any_of(
      subscriptions_, [&](const Subscription& each) { return is_service(each, service) && is_of(each, key, flow); });
}

std::vector<std::string> Flows::demanded(std::string_view key) const {
  std::vector<std::string> flows;
  for (const Subscription& each : subscriptions_)
    if (each.key == key && std::ranges::find(flows, each.flow) == flows.end()) flows.push_back(each.flow);
  return flows;
}

void Flows::set_subscription(std::size_t service, std::string_view key, std::string_view flow, bool on) {
  const auto same = [&](const Subscription& each) { return is_service(each, service) && is_of(each, key, flow); };
  if (!on) {
    std::erase_if(subscriptions_, same);
    drop_undemanded();
  } else if (std::ranges::none_of(subscriptions_, same)) {
    subscriptions_.push_back({std::string(key), std::string(flow), service, {}, 0, {}});
  }
}

Flows::WatchId Flows::watch(std::string_view key, std::string_view flow, Watcher watcher) {
  subscriptions_.push_back({std::string(key), std::string(flow), 0, {}, next_watch_, std::move(watcher)});
  return next_watch_++;
}

Flows::Subscription Flows::unwatch(WatchId id) {
  const auto found = std::ranges::find(subscriptions_, id, &Subscription::watch);
  if (id == 0 || found == subscriptions_.end()) return {};
  Subscription removed = std::move(*found);
  subscriptions_.erase(found);
  drop_undemanded();
  return removed;
}

std::vector<std::size_t> Flows::publish(std::string_view key, std::string_view flow, const PacketPtr& packet) {
  std::vector<std::size_t> services;
  for (Subscription& each : subscriptions_) {
    if (!is_of(each, key, flow)) continue;
    if (each.watch != 0) {
      each.watcher(packet);
    } else if (!std::exchange(each.waiting, packet)) {
      services.push_back(each.service);
    }
  }
  return services;
}

PacketPtr Flows::take(std::size_t service, std::string_view key, std::string_view flow) {
  for (Subscription& each : subscriptions_)
    if (is_service(each, service) && is_of(each, key, flow)) return std::exchange(each.waiting, nullptr);
  return nullptr;
}

bool Flows::record(std::string_view key, std::string_view flow, const Packet& packet, Time now) {
  constexpr Time kReportPeriod = 1;
  auto passed =
      std::ranges::find_if(traffic_, [&](const Traffic& each) { return each.key == key && each.flow == flow; });
  if (passed == traffic_.end())
    passed = traffic_.insert(traffic_.end(), {std::string(key), std::string(flow), {}, {}, now});
  passed->last = {packet.time, packet.header};
  passed->times.push_back(now);
  if (passed->times.size() > kCounted) passed->times.pop_front();
  if (passed->times.size() > 2 && now - passed->reported < kReportPeriod) return false;
  passed->reported = now;
  return true;
}

Time Flows::Traffic::period() const {
  return times.size() < 2 ? 0 : (times.back() - times.front()) / static_cast<double>(times.size() - 1);
}

bool Flows::Traffic::has_stopped(Time now) const {
  constexpr Time kTolerance = 1;  // beside three periods
  return period() > 0 && now - times.back() > 3 * period() + kTolerance;
}

Published Flows::traffic(std::string_view key, std::string_view flow, Time now) const {
  Published traffic{std::string(flow), 0, 0, {}};
  for (const Subscription& each : subscriptions_)
    if (each.watch != 0 && is_of(each, key, flow)) ++traffic.watchers;
  const auto passed =
      std::ranges::find_if(traffic_, [&](const Traffic& each) { return each.key == key && each.flow == flow; });
  if (passed == traffic_.end()) return traffic;
  traffic.last = passed->last;
  if (const Time period = passed->period(); period > 0 && !passed->has_stopped(now)) traffic.rate_hz = 1 / period;
  return traffic;
}

std::vector<std::string> Flows::stopped(Time now) {
  std::vector<std::string> keys;
  for (Traffic& each : traffic_) {
    if (!each.has_stopped(now)) continue;
    each.times.clear();
    keys.push_back(each.key);
  }
  return keys;
}

void Flows::reset(std::string_view key) {
  std::erase_if(traffic_, [&](const Traffic& each) { return each.key == key; });
}

void Flows::drop_undemanded() {
  std::erase_if(traffic_, [&](const Traffic& each) { return !has_demand(each.key, each.flow); });
}

std::vector<Flows::Subscription> Flows::subscriptions_of(std::size_t service) const {
  std::vector<Subscription> all;
  std::ranges::copy_if(subscriptions_, std::back_inserter(all),
                       [&](const auto& each) { return is_service(each, service); });
  return all;
}

}  // namespace race::services
