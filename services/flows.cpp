#include "services/flows.h"

#include <algorithm>

namespace race::services {
namespace {

bool hears(const Flows::Listener& each, std::string_view key, std::string_view flow) {
  return each.key == key && each.flow == flow;
}

bool is_service(const Flows::Listener& each, std::size_t service) { return each.watch == 0 && each.service == service; }

}  // namespace

bool Flows::wanted(std::string_view key, std::string_view flow) const {
  return std::ranges::any_of(listeners_, [&](const Listener& each) { return hears(each, key, flow); });
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

std::vector<Flows::Listener> Flows::of(std::size_t service) const {
  std::vector<Listener> all;
  std::ranges::copy_if(listeners_, std::back_inserter(all),
                       [&](const auto& each) { return is_service(each, service); });
  return all;
}

}  // namespace race::services
