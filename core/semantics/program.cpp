#include "core/semantics/program.h"

#include "core/language/check/checker.h"
#include "core/semantics/program_internal.h"

namespace race::semantics {
namespace {

template <typename Id>
std::optional<Id> found(const IdIndex& ids, std::string_view id) {
  const auto number = ids.find(id);
  return number ? std::optional(Id{*number}) : std::nullopt;
}

}  // namespace

Checked<std::shared_ptr<const Program>> Program::build(const rcm::NativeModel& model,
                                                       const std::map<std::string, rsm::Service>& services) {
  auto program = std::make_shared<Program>();
  for (const auto& [key, service] : services) {
    for (const rsm::Event& event : service.events) program->services.declare_event(key, event.name, event.sampled);
    for (const rsm::Operation& operation : service.operations)
      program->services.declare_operation(key, operation.name, operation.safe);
  }
  std::vector<Error> errors = compile_code(*program, lay_out(*program, model));
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return std::shared_ptr<const Program>(std::move(program));
}

std::optional<StateId> Program::find_state(std::string_view path) const {
  for (std::uint32_t s = 0; s < states.size(); ++s)
    if (states[s].path == path) return StateId{s};
  return std::nullopt;
}

std::optional<PortId> Program::find_port(std::string_view address) const {
  const auto dot = address.rfind('.');
  if (dot == std::string_view::npos) return std::nullopt;
  const auto state = find_state(address.substr(0, dot));
  if (!state) return std::nullopt;
  for (const PortId port : (*this)[*state].ports)
    if ((*this)[port].name == address.substr(dot + 1)) return port;
  return std::nullopt;
}

std::optional<StateId> Program::state_with_id(std::string_view id) const { return found<StateId>(ids.states, id); }
std::optional<PortId> Program::port_with_id(std::string_view id) const { return found<PortId>(ids.ports, id); }

}  // namespace race::semantics
