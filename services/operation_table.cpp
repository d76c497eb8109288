#include "services/operation_table.h"

#include <cassert>

#include "core/rsm/document.h"
#include "core/rsm/rules.h"

namespace race::services {
namespace {

rsm::OperationParameter to_model(const ParameterRow& row) {
  rsm::OperationParameter parameter{row.name, row.type, row.unit, row.doc, row.min, row.max, row.value};
  parameter.type.freeze();
  if (parameter.value) parameter.value->freeze();
  return parameter;
}

rsm::Operation to_model(const OperationRow& row) {
  rsm::Operation operation{row.name, {},        row.result, row.error, row.safe,
                           row.doc,  row.moves, row.held,   row.paces, row.reads};
  for (const ParameterRow& parameter : row.parameters) operation.parameters.push_back(to_model(parameter));
  operation.result.freeze();
  operation.error.freeze();
  return operation;
}

rsm::Event to_model(const EventRow& row) {
  rsm::Event event{row.name, row.data, row.sampled, row.rate_hz, row.doc};
  event.data.freeze();
  return event;
}

rsm::Transition to_model(const TransitionRow& row) {
  return {row.id, row.src, row.dst, row.operation, row.events, row.defer, row.error, row.concurrent};
}

rsm::Service to_model(const Declaration& declaration) {
  rsm::Service service;
  service.name = declaration.name;
  for (const OperationRow& row : declaration.operations) service.operations.push_back(to_model(row));
  for (const EventRow& row : declaration.events) service.events.push_back(to_model(row));
  service.subscribes = declaration.subscribes;
  service.states = declaration.states;
  service.init = declaration.init;
  for (const TransitionRow& row : declaration.transitions) service.transitions.push_back(to_model(row));
  service.meta = declaration.meta;
  service.meta.freeze();
  return service;
}

}  // namespace

OperationTable::OperationTable(const Declaration& declaration) : model_(to_model(declaration)) {
  assert(rsm::violations(model_, declaration.name).empty());
  for (const OperationRow& row : declaration.operations) operations_[row.name] = {row.handler, row.acceptance};
  for (const TransitionRow& row : declaration.transitions) {
    assert(row.refused.empty() || rsm::find_transition(model_, row.refused));
    refused_[row.id] = row.refused;
  }
}

const OperationTable::Operation& OperationTable::operation(std::string_view name) const {
  return operations_.find(name)->second;
}

const std::string& OperationTable::refused(std::string_view transition) const {
  return refused_.find(transition)->second;
}

}  // namespace race::services
