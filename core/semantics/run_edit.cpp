// A run that is edited, or told something from outside, between macro steps (core/SEMANTICS.md section 9). Both make
// the run anew, from what it carries over: that costs the size of the model, and nothing else pays for it.
#include <algorithm>
#include <cassert>

#include "core/semantics/run_internal.h"

namespace race::semantics {
namespace {

/// Resolves parameters of active states that have no value (those that have one are not resolved again, R10), parents
/// before children; children of one parent do not see what the others get (as in R23).
class Resolver {
 public:
  Resolver(const Program& program, RunState& run, StepEnvironment& environment, language::Interpreter& interpreter)
      : program_(program), run_(run), environment_(environment), interpreter_(interpreter) {}

  std::vector<Obstacle> resolve() {
    resolve_of(Program::root);
    write();
    for (std::uint32_t s = 0; s < program_.states.size(); ++s) {
      for (const NodeRef child : program_[StateId{s}].children)
        if (!child.barrier) resolve_of(child.state());
      write();
    }
    return std::move(obstacles_);
  }

 private:
  void resolve_of(StateId s) {
    if (!run_.flags[program_.flag(s)]) return;
    const StateInfo& info = program_[s];
    for (std::uint32_t i = 0; i < info.parameters.size(); ++i) {
      const ValueIndex at = info.first_parameter + i;
      if (!run_.values[at].is_unknown()) continue;
      Value value = value_of(info.parameters[i], info.parent);
      if (value.is_unknown() || !value.is_finite())
        obstacles_.push_back({Obstacle::Kind::unresolved, info.path, program_.id(s), info.parameters[i].name});
      else
        resolved_.emplace_back(at, std::move(value));
    }
  }

  Value value_of(const ParameterInfo& parameter, StateId parent) {
    if (parameter.value) return *parameter.value;
    if (!parameter.from || parent == kNoState) return Value::unknown();
    environment_.enter(parent, false);
    return interpreter_.expression(parameter.from, environment_).value_or(Value::unknown());
  }

  void write() {
    for (auto& [at, value] : resolved_) run_.values[at] = std::move(value);
    resolved_.clear();
  }

  const Program& program_;
  RunState& run_;
  StepEnvironment& environment_;
  language::Interpreter& interpreter_;
  std::vector<Obstacle> obstacles_;
  std::vector<std::pair<ValueIndex, Value>> resolved_;
};

}  // namespace

// The run at the beginning of the macro step that delivers the edit; its lists and counts are not filled in.
std::unique_ptr<Run::Body> Run::carried_body(std::shared_ptr<const Program> program, const Correspondence& same) const {
  assert(body_->status == Status::running && body_->outgoing.empty());
  auto body = std::make_unique<Body>(std::move(program), body_->budgets);
  body->state = carried_state(*body_->program, body_->state, *body->program, same);
  body->environment.attach();
  body->position = body_->position + 1;
  open_complete_barriers(*body->program, body->state);
  return body;
}

tl::expected<Run, std::vector<Obstacle>> Run::edited(std::shared_ptr<const Program> program) const {
  const Correspondence same(*body_->program, *program);
  if (auto lost = lost_nodes(*body_->program, body_->state, same); !lost.empty())
    return tl::unexpected(std::move(lost));
  auto body = carried_body(std::move(program), same);
  auto unresolved = Resolver(*body->program, body->state, body->environment, body->interpreter).resolve();
  if (!unresolved.empty()) return tl::unexpected(std::move(unresolved));
  fill_lists(body->state, *body->program);
  return Run(std::move(body));
}

namespace {

tl::unexpected<Error> not_found(const Force& force) {
  return unexpected(ErrorCode::not_found,
                    "the state has no `" + std::string(name(force.scope)) + "." + force.name + "`", force.path);
}

std::optional<ValueIndex> find_value(const StateInfo& info, const Force& force) {
  const auto place = [&](const auto& names, ValueIndex first, auto name) -> std::optional<ValueIndex> {
    const auto found = std::ranges::find(names, force.name, name);
    return found == names.end() ? std::nullopt : std::optional(first + static_cast<ValueIndex>(found - names.begin()));
  };
  switch (force.scope) {
    case Force::Scope::par:
      return place(info.parameters, info.first_parameter, &ParameterInfo::name);
    case Force::Scope::res:
      return place(info.results, info.first_result, std::identity{});
    case Force::Scope::var:
      return place(info.variables, info.first_variable, std::identity{});
    case Force::Scope::port:
      break;
  }
  return std::nullopt;
}

}  // namespace

Expected<Run> Run::forced(const Force& force) const {
  const Program& program = *body_->program;
  const auto s = program.find_state(force.path);
  if (!s) return unexpected(ErrorCode::not_found, "there is no such state", force.path);
  const auto at = find_value(program[*s], force);
  const auto port = force.scope == Force::Scope::port ? program.find_port(force.path + "." + force.name) : std::nullopt;
  if (!at && !port) return not_found(force);
  if (port && !is_active(*s)) return unexpected(ErrorCode::conflict, "the state is not active", force.path);
  if (at && (force.value.is_unknown() || !force.value.is_finite()))
    return unexpected(ErrorCode::constant, "the value is not finite", force.path);
  if (at && force.value.size_units() > body_->budgets.evaluation.value_units)
    return unexpected(ErrorCode::too_large, "the value is larger than one of this run may be", force.path);
  auto body = carried_body(body_->program, Correspondence::identity(program));
  if (at) body->state.values[*at] = force.value;
  if (port) body->state.forced = *port;
  fill_lists(body->state, program);
  return Run(std::move(body));
}

}  // namespace race::semantics
