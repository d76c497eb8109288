#include "services/flows.h"

#include <algorithm>

namespace race::services {
namespace {

bool hears(const Flows::Listener& each, std::string_view key, std::string_view flow) {
  return each.key == key && each.flow == flow;
}

bool is_service(const Flows::Listener& each, std::size_t service) { return each.watch == 0 && each.service == service; }

}  // namespace

std::vector<std::string> offered(const rsm::Service& model) {
  std::vector<std::string> names;
  const Value* flows = model.meta.find("flows");
  if (!flows || !flows->is_dict()) return names;
  for (const auto& [name, text] : flows->as_dict()) names.push_back(name.as_string());
  return names;
}

bool Flows::wanted(std::string_view key, std::string_view flow) const {
  return std::ranges::any_of(listeners_, [&](const Listener& each) { return hears(each, key, flow); });
}

bool Flows::listens(std::size_t service, std::string_view key, std::string_view flow) const {
  return std::ranges::any_of(listeners_,
                             [&](const Listener& each) { return is_service(each, service) && hears(each, key, flow); });
}

std::vector<std::string> Flows::wanted_of(std::string_view key) const {
  std::vector<std::string> flows;
  for (const Listener& each : listeners_)
    if (each.key == key && std::ranges::find(flows, each.flow) == flows.end()) flows.push_back(each.flow);
  return flows;
}

void Flows::listen(std::size_t service, std::string_view key, std::string_view flow, bool on) {
  const auto same = [&](const Listener& each) { return is_service(each, service) && hears(each, key, flow); };
  if (!on) {
    std::erase_if(listeners_, same);
    forget_unwanted();
  } else if (std::ranges::none_of(listeners_, same)) {
    listeners_.push_back({std::string(key), std::string(flow), service, {}, 0, {}});
  }
}

Flows::WatchId Flows::watch(std::string_view key, std::string_view flow, Watcher watcher) {
  listeners_.push_back({std::string(key), std::string(flow), 0, {}, next_watch_, std::move(watcher)});
  return next_watch_++;
}

Flows::Listener Flows::unwatch(WatchId id) {
  const auto found = std::ranges::find(listeners_, id, &Listener::watch);
  if (id == 0 || found == listeners_.end()) return {};
  Listener gone = std::move(*found);
  listeners_.erase(found);
  forget_unwanted();
  return gone;
}

std::vector<std::size_t> Flows::publish(std::string_view key, std::string_view flow, const PacketPtr& packet) {
  std::vector<std::size_t> services;
  for (Listener& each : listeners_) {
    if (!hears(each, key, flow)) continue;
    if (each.watch != 0) {
      each.watcher(packet);
    } else if (!std::exchange(each.waiting, packet)) {
      services.push_back(each.service);
    }
  }
  return services;
}

PacketPtr Flows::take(std::size_t service, std::string_view key, std::string_view flow) {
  for (Listener& each : listeners_)
    if (is_service(each, service) && hears(each, key, flow)) return std::exchange(each.waiting, nullptr);
  return nullptr;
}

bool Flows::count(std::string_view key, std::string_view flow, const Packet& packet, Time now) {
  constexpr Time kTold = 1;
  auto passed = std::ranges::find_if(passed_, [&](const Passed& each) { return each.key == key && each.flow == flow; });
  if (passed == passed_.end())
    passed = passed_.insert(passed_.end(), {std::string(key), std::string(flow), {}, {}, now});
  passed->last = {packet.time, packet.header};
  passed->times.push_back(now);
  if (passed->times.size() > kCounted) passed->times.pop_front();
  if (passed->times.size() > 2 && now - passed->told < kTold) return false;
  passed->told = now;
  return true;
}

Time Flows::Passed::period() const {
  return times.size() < 2 ? 0 : (times.back() - times.front()) / static_cast<double>(times.size() - 1);
}

bool Flows::Passed::has_stopped(Time now) const {
  constexpr Time kPatience = 1;  // beside three periods
  return period() > 0 && now - times.back() > 3 * period() + kPatience;
}

Published Flows::traffic(std::string_view key, std::string_view flow, Time now) const {
  Published traffic{std::string(flow), 0, 0, {}};
  for (const Listener& each : listeners_)
    if (each.watch != 0 && hears(each, key, flow)) ++traffic.watchers;
  const auto passed =
      std::ranges::find_if(passed_, [&](const Passed& each) { return each.key == key && each.flow == flow; });
  if (passed == passed_.end()) return traffic;
  traffic.last = passed->last;
  if (const Time period = passed->period(); period > 0 && !passed->has_stopped(now)) traffic.rate_hz = 1 / period;
  return traffic;
}

std::vector<std::string> Flows::stopped(Time now) {
  std::vector<std::string> keys;
  for (Passed& each : passed_) {
    if (!each.has_stopped(now)) continue;
    each.times.clear();
    keys.push_back(each.key);
  }
  return keys;
}

void Flows::fall_silent(std::string_view key) {
  std::erase_if(passed_, [&](const Passed& each) { return each.key == key; });
}

void Flows::forget_unwanted() {
  std::erase_if(passed_, [&](const Passed& each) { return !wanted(each.key, each.flow); });
}

std::vector<Flows::Listener> Flows::of(std::size_t service) const {
  std::vector<Listener> all;
  std::ranges::copy_if(listeners_, std::back_inserter(all),
                       [&](const auto& each) { return is_service(each, service); });
  return all;
}

}  // namespace race::services
