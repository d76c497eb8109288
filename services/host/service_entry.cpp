#include "services/host/service_entry.h"

#include <algorithm>
#include <ranges>
#include <utility>

namespace race::services {
namespace {

void freeze(rsm::Service& service) {
  for (rsm::Operation& operation : service.operations) {
    operation.result.freeze();
    operation.error.freeze();
    for (rsm::OperationParameter& parameter : operation.parameters) {
      parameter.type.freeze();
      if (parameter.value) parameter.value->freeze();
    }
  }
  for (rsm::Event& event : service.events) event.data.freeze();
  service.meta.freeze();
}

}  // namespace

ServiceEntry::ServiceEntry(std::size_t its_number, std::string key, std::string type, WorkQueue& its_queue)
    : number(its_number), queue(its_queue) {
  status.key = std::move(key);
  status.type = std::move(type);
}

std::unique_ptr<Component> ServiceEntry::attach(std::unique_ptr<Component> its_component) {
  std::unique_ptr<Component> before = std::exchange(component, std::move(its_component));
  auto its_model = std::make_shared<rsm::Service>(component->model());
  freeze(*its_model);
  model = std::move(its_model);
  ledger = std::make_unique<CallLedger>(*model);
  status.model = model;
  status.last.clear();
  status.publishes.clear();
  status.subscribes.clear();
  for (std::string& flow : offered(*model)) status.publishes.push_back({std::move(flow), 0, 0, {}});
  for (const rsm::Uses& used : model->subscribes) status.subscribes.push_back({used.service, used.name, false});
  return before;
}

bool ServiceEntry::declares_subscription(std::string_view key, std::string_view flow) const {
  return std::ranges::any_of(model->subscribes,
                             [&](const rsm::Uses& used) { return used.service == key && used.name == flow; });
}

void ServiceEntry::update_status(const Flows& flows, Time now) {
  if (!ledger) return;  // declared and not attached yet
  status.state.reset();
  if (!model->is_interface()) status.state = ledger->state();
  status.pending_count = ledger->pending().size();
  status.pending.clear();
  for (const auto& [id, call] : ledger->pending() | std::views::take(ServiceStatus::kPendingShown))
    status.pending.push_back(call);
  status.violations = ledger->violations();
  for (Published& each : status.publishes) each = flows.published(status.key, each.flow, now);
  for (Subscribed& each : status.subscribes) each.listening = flows.is_subscribed(number, each.service, each.flow);
}

}  // namespace race::services
