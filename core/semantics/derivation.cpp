#include "core/semantics/derivation.h"

namespace race::semantics {

void Derivation::clear() {
  nodes.clear();
  resolved.clear();
  calls.clear();
  required.clear();
  micro.clear();
}

namespace {

class Writer {
 public:
  Writer(const Program& program, const Derivation& derivation) : p_(program), d_(derivation) {}

  Value node(std::size_t at) const {
    const DerivationNode& n = d_.nodes[at];
    const RuleInfo& rule = info(n.rule);
    Dict out;
    out.set("rule", rule.name);
    out.set("equation", rule.equation);
    out.set("at", p_.node_path(n.at));
    if (n.of != FunctionOf::none)
      out.set("of", n.of == FunctionOf::entry ? "entry" : n.of == FunctionOf::exit ? "exit" : "action");
    if (n.port != kNoPort) {
      const PortInfo& port = p_[n.port];
      const bool own =
          p_.flag(port.state) == n.at && n.rule != Rule::SAct1 && n.rule != Rule::SAct2;  // these name the context
      out.set("port", own ? port.name : p_.address(n.port));
    }
    if (n.action != kNone) out.set("action", static_cast<std::int64_t>(n.action));
    if (n.rule == Rule::Resolve) {
      const Resolved& resolved = d_.resolved[n.detail];
      out.set("parameter", p_.states[n.at].parameters[resolved.parameter].name);
      out.set("value", resolved.value);
    }
    if (n.rule == Rule::FuncSC) call(d_.calls[n.detail], out);
    if (n.value != NodeValue::none)
      out.set("value", n.value == NodeValue::unknown ? Value() : Value(n.value == NodeValue::yes));
    if (n.required_count > 0) out.set("requires", required(n));
    if (n.refinement != 0) out.set("refinement", "R" + std::to_string(n.refinement));
    List premises;
    for (std::size_t child = at + 1; child < at + n.size; child += d_.nodes[child].size)
      premises.push_back(node(child));
    out.set("premises", std::move(premises));
    return out;
  }

 private:
  static void call(const OutgoingCall& c, Dict& out) {
    out.set("service", c.service);
    out.set("operation", c.name);
    out.set("args", c.args);
    out.set("kwargs", c.kwargs);
  }

  List required(const DerivationNode& n) const {
    List out;
    for (std::uint32_t i = n.required; i < n.required + n.required_count; ++i) {
      const RequiredDatum& datum = d_.required[i];
      if (datum.kind == RequiredDatum::Kind::event) {
        const auto& event = p_.services.events()[datum.number];
        out.emplace_back(event.service + "." + event.name);
      } else {
        const auto& operation = p_.services.operations()[datum.number];
        const std::string& service = p_.services.is_open(datum.number) ? datum.service : operation.service;
        out.emplace_back(service + "." + operation.name +
                         (datum.kind == RequiredDatum::Kind::error ? ".error" : ".result"));
      }
    }
    return out;
  }

  const Program& p_;
  const Derivation& d_;
};

}  // namespace

Value derivation_json(const Program& program, const Derivation& derivation, std::size_t number) {
  return Writer(program, derivation).node(derivation.micro[number]);
}

}  // namespace race::semantics
