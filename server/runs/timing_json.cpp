#include "server/runs/timing_json.h"

#include <algorithm>
#include <map>
#include <utility>

namespace race::server {
namespace {

Value step_json(std::uint64_t number, const StepTime& step) {
  Dict json{{"step", static_cast<std::int64_t>(number)}, {"time", step.time}};
  if (step.input) json.set("arrived", step.input->time);
  return json;
}

// Of a step that is there twice, as its run was rebuilt, the later one is what happened.
List steps_json(const std::vector<TimingBlock>& blocks, std::uint64_t from, std::uint64_t to) {
  std::map<std::uint64_t, const StepTime*> steps;
  for (const TimingBlock& block : blocks)
    for (std::size_t i = 0; i < block.steps.size(); ++i)
      if (block.first + i >= from && block.first + i <= to) steps[block.first + i] = &block.steps[i];
  List list;
  for (const auto& [number, step] : steps) list.push_back(step_json(number, *step));
  return list;
}

}  // namespace

Expected<std::vector<TimingBlock>> timing_blocks(Runs& runs, RunId run, std::uint64_t from, std::uint64_t to,
                                                 const std::vector<TimingBlock>& recent) {
  std::vector<TimingBlock> blocks;
  const auto read = runs.timing(run, from, recent, [&](const TimingBlock& block) {
    blocks.push_back(block);
    return block.last() <= to;  // services may have changed since
  });
  if (!read) return tl::unexpected(read.error());
  return blocks;
}

// Services say their states anew with each block.
Value timing_json(const std::vector<TimingBlock>& blocks, std::uint64_t from, std::uint64_t to) {
  List services;
  std::map<std::string, std::optional<std::string>> known;
  std::int64_t until = 0;
  for (const TimingBlock& block : blocks) {
    for (const ServiceChange& change : block.services) {
      const auto [state, is_new] = known.try_emplace(change.service, change.state);
      if (!is_new && state->second == change.state) continue;
      state->second = change.state;
      Dict json{{"time", change.time}, {"service", change.service}};
      if (change.state) json.set("state", *change.state);
      services.emplace_back(std::move(json));
      until = std::max(until, change.time);
      if (services.size() < kMostStates) continue;
      return Dict{{"steps", steps_json(blocks, from, to)}, {"services", std::move(services)}, {"until", until}};
    }
    until = std::max(until, block.ends);
  }
  return Dict{{"steps", steps_json(blocks, from, to)}, {"services", std::move(services)}, {"until", until}};
}

}  // namespace race::server
