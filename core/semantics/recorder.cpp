#include "core/semantics/recorder.h"

namespace race::semantics {
namespace {

NodeValue node_value(language::Truth truth) {
  if (truth == language::Truth::yes) return NodeValue::yes;
  return truth == language::Truth::no ? NodeValue::no : NodeValue::unknown;
}

}  // namespace

void TreeRecorder::add_part(Rule rule, Flag at, language::Truth value) {
  derivation.nodes.push_back({.at = at, .rule = rule, .value = node_value(value)});
}

void TreeRecorder::add_part(Rule rule, Flag at) { derivation.nodes.push_back({.at = at, .rule = rule}); }

void TreeRecorder::add_call(Flag at, const OutgoingCall& call) {
  derivation.nodes.push_back(
      {.at = at, .detail = static_cast<std::uint32_t>(derivation.calls.size()), .rule = Rule::FuncSC});
  derivation.calls.push_back(call);
}

void TreeRecorder::Node::value(language::Truth truth) { node().value = node_value(truth); }

void TreeRecorder::Node::resolved(std::uint32_t parameter, const Value& value) {
  node().detail = static_cast<std::uint32_t>(derivation_.resolved.size());
  derivation_.resolved.push_back({parameter, value});
}

void TreeRecorder::Node::required(const std::vector<RequiredDatum>& data) {
  node().required = static_cast<std::uint32_t>(derivation_.required.size());
  node().required_count = static_cast<std::uint16_t>(data.size());
  for (const RequiredDatum& datum : data) derivation_.required.push_back(datum);
}

TreeRecorder::Postponed::Postponed(Derivation& derivation, Mark mark)
    : derivation_(derivation),
      nodes_(derivation.nodes.begin() + static_cast<std::ptrdiff_t>(mark), derivation.nodes.end()) {
  derivation_.nodes.resize(mark);
}

void TreeRecorder::Postponed::insert(Flag at) {
  for (const DerivationNode& node : nodes_)
    if (node.at == at) derivation_.nodes.push_back(node);
  std::erase_if(nodes_, [&](const DerivationNode& node) { return node.at == at; });
}

}  // namespace race::semantics
