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
  return std::ranges::any_of(subscriptions_,
                             [&](const Subscription& each) { return each.is_wanted && is_of(each, key, flow); });
}

bool Flows::is_subscribed(std::size_t service, std::string_view key, std::string_view flow) const {
  return std::ranges::any_of(
      subscriptions_, [&](const Subscription& each) { return is_service(each, service) && is_of(each, key, flow); });
}

std::vector<std::string> Flows::demanded(std::string_view key) const {
  std::vector<std::string> flows;
  for (const Subscription& each : subscriptions_)
    if (each.key == key && each.is_wanted && std::ranges::find(flows, each.flow) == flows.end())
      flows.push_back(each.flow);
  return flows;
}

std::vector<Flows::Subscription> Flows::subscriptions_of(std::size_t service) const {
  std::vector<Subscription> all;
  std::ranges::copy_if(subscriptions_, std::back_inserter(all),
                       [&](const auto& each) { return is_service(each, service); });
  return all;
}

void Flows::set_subscription(std::size_t service, std::string_view key, std::string_view flow, bool on) {
  const auto same = [&](const Subscription& each) { return is_service(each, service) && is_of(each, key, flow); };
  if (!on) {
    std::erase_if(subscriptions_, same);
    if (!has_demand(key, flow)) traffic_.reset(key, flow);
  } else if (std::ranges::none_of(subscriptions_, same)) {
    subscriptions_.push_back({std::string(key), std::string(flow), service, {}, 0, true, {}});
  }
}

Flows::WatchId Flows::watch(std::string_view key, std::string_view flow, Watcher watcher) {
  return add({std::string(key), std::string(flow), 0, {}, next_watch_, true, std::move(watcher)});
}

Flows::WatchId Flows::overhear(std::string_view key, std::string_view flow, Watcher watcher) {
  return add({std::string(key), std::string(flow), 0, {}, next_watch_, false, std::move(watcher)});
}

Flows::WatchId Flows::add(Subscription watch) {
  subscriptions_.push_back(std::move(watch));
  return next_watch_++;
}

Flows::Subscription Flows::unwatch(WatchId id) {
  const auto found = std::ranges::find(subscriptions_, id, &Subscription::watch);
  if (id == 0 || found == subscriptions_.end()) return {};
  Subscription removed = std::move(*found);
  subscriptions_.erase(found);
  if (!has_demand(removed.key, removed.flow)) traffic_.reset(removed.key, removed.flow);
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

Published Flows::published(std::string_view key, std::string_view flow, Time now) const {
  Published published = traffic_.read(key, flow, now);
  published.watchers = static_cast<std::size_t>(std::ranges::count_if(subscriptions_, [&](const Subscription& each) {
    return each.watch != 0 && each.is_wanted && is_of(each, key, flow);
  }));
  return published;
}

}  // namespace race::services
