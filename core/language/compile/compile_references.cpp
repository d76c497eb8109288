// Compiling names and paths: places in Δ, and service data.
#include "core/language/compile/compiler_internal.h"

namespace race::language {

NodeId Compiler::reference(const Expr& e, const Reference& r, bool boolean_position) {
  switch (r.meaning) {
    case Meaning::collection:
      return collection(e, r.text);
    case Meaning::value:
      reads(r.number);
      return emit(Opcode::slot, e.at, r.number);
    case Meaning::flag:
      flags_.insert(r.number);
      return emit(Opcode::flag, e.at, r.number);
    case Meaning::child_name:
      return emit(Opcode::constant, e.at, name_constant(r.text));
    case Meaning::constant:
      return emit(Opcode::constant, e.at, constant(*r.constant));
    default:
      return r.dynamic != nullptr ? dynamic_read(e, r, boolean_position) : service_read(e, r, boolean_position);
  }
}

NodeId Compiler::service_read(const Expr& e, const Reference& r, bool boolean_position) {
  service_ = true;
  program_->mentions.svc = true;
  if (r.meaning == Meaning::data) {
    const EventId event = services_.event(r.service, r.name);
    events_.insert(event);
    return emit(boolean_position ? Opcode::event_present : Opcode::event, e.at, event);
  }
  if (r.meaning == Meaning::latest) {
    const EventId event = services_.event(r.service, r.name);
    latest_.insert(event);
    return emit(Opcode::event_latest, e.at, event);
  }
  // `result` and `error` of a known event that is no operation are fields of its data.
  const EventId event = services_.find_event(r.service, r.name);
  if (event != kNone && services_.find_operation(r.service, r.name) == kNone) {
    events_.insert(event);
    return emit(Opcode::field, e.at, emit(Opcode::event, e.at, event), name_constant(e.name));
  }
  const OperationId operation = services_.operation(r.service, r.name);
  responses_.insert(operation);
  const std::uint32_t error = r.meaning == Meaning::error ? 1 : 0;
  return emit(boolean_position ? Opcode::response_present : Opcode::response, e.at, operation, error);
}

NodeId Compiler::dynamic_read(const Expr& e, const Reference& r, bool boolean_position) {
  const NodeId service = expression(*r.dynamic);
  service_ = true;
  program_->mentions.svc = true;
  const std::uint32_t name = name_constant(r.name);
  bool is_event = r.meaning == Meaning::data || r.meaning == Meaning::latest;
  bool known_event = false;
  bool known_operation = false;
  for (const auto& event : services_.events()) known_event = known_event || event.name == r.name;
  for (const auto& operation : services_.operations()) known_operation = known_operation || operation.name == r.name;
  const bool field = !is_event && known_event && !known_operation;
  if (is_event || field) {
    std::set<EventId>& mentioned = r.meaning == Meaning::latest ? latest_ : events_;
    for (EventId id = 0; id < services_.events().size(); ++id)
      if (services_.events()[id].name == r.name) mentioned.insert(id);
    const DynamicRead how = r.meaning == Meaning::latest ? DynamicRead::latest
                            : boolean_position && !field ? DynamicRead::present
                                                         : DynamicRead::data;
    const NodeId data = emit(Opcode::dynamic_event, e.at, service, name, static_cast<std::uint32_t>(how));
    return field ? emit(Opcode::field, e.at, data, name_constant(e.name)) : data;
  }
  services_.open_operation(r.name);
  for (OperationId id = 0; id < services_.operations().size(); ++id)
    if (services_.operations()[id].name == r.name) responses_.insert(id);
  const std::uint32_t bits = (r.meaning == Meaning::error ? 1U : 0U) | (boolean_position ? 2U : 0U);
  return emit(Opcode::dynamic_response, e.at, service, name, bits);
}

NodeId Compiler::collection(const Expr& e, std::string_view name) {
  const auto& slots = name == "par" ? symbols_.parameters : name == "res" ? symbols_.results : symbols_.variables;
  Collection made;
  for (const auto& [key, slot] : slots) {
    made.entries.emplace_back(name_constant(key), slot);
    reads(slot);
  }
  program_->collections.push_back(std::move(made));
  return emit(Opcode::collection, e.at, static_cast<std::uint32_t>(program_->collections.size() - 1));
}

}  // namespace race::language
