#include "services/table_component.h"

#include <cassert>
#include <utility>

#include "core/rsm/rules.h"
#include "services/arguments.h"

namespace race::services {

TableComponent::TableComponent(const OperationTable& table, ServiceHost& host)
    : table_(table), host_(host), state_(rsm::initial(table.model()).current) {}

void TableComponent::call(const Call& call) {
  accepted_by_ = nullptr;
  if (!rsm::taken_on(model(), {state_, {}}, call.operation)) return host_.reject(call.id);
  const OperationTable::Operation& operation = table_.operation(call.operation);
  if (operation.acceptance == Acceptance::before_handler) accept(call);
  if (!operation.handler.takes_arguments()) return operation.handler(*this, call, {});
  const auto arguments = bind_arguments(*find_operation(model(), call.operation), call);
  if (!arguments) return refuse_arguments(call, arguments.error());
  operation.handler(*this, call, *arguments);
}

void TableComponent::take(std::string_view id, CallId call) {
  const rsm::Transition* transition = rsm::find_transition(model(), id);
  assert(transition && !transition->operation && rsm::leaves_current(*transition, {state_, {}}));
  host_.transition(id, call);
  state_ = transition->dst;
}

void TableComponent::accept(const Call& call) {
  accepted_by_ = rsm::taken_on(model(), {state_, {}}, call.operation);
  assert(accepted_by_);
  host_.transition(accepted_by_->id, call.id);
  state_ = accepted_by_->dst;
}

void TableComponent::refuse(const Call& call, Value error) {
  if (!accepted_by_) accept(call);
  if (const std::string& refused = table_.refused(accepted_by_->id); !refused.empty())
    take(refused, accepted_by_->concurrent ? call.id : 0);
  host_.error(call.id, std::move(error));
}

void TableComponent::refuse_arguments(const Call& call, const Error& error) {
  Value answer = error_value(error);
  if (!error.path.empty()) answer.mutable_dict().set("argument", Value(error.path));
  refuse(call, std::move(answer));
}

}  // namespace race::services
