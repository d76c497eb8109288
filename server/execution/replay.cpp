#include "server/execution/replay.h"

#include "server/execution/why.h"

namespace race::server {

using semantics::Run;

Replay::Replay(JournalHeader header) : header_(std::move(header)) {}

namespace {

// The macro step of one entry, with at most `limit` micro steps (negative: all).
template <semantics::Recorder R>
void apply(Run& run, const JournalEntry& entry, R& recorder, int limit) {
  if (entry.kind == JournalEntry::Kind::abort) return run.abort();
  run.begin(entry.kind == JournalEntry::Kind::input ? std::optional(entry.input) : std::nullopt);
  for (int done = 0; (limit < 0 || done < limit) && run.micro(recorder); ++done) {
  }
}

}  // namespace

// The run after the first `position` entries.
Run& Replay::at(const std::vector<JournalEntry>& journal, std::size_t position) {
  const auto after = checkpoints_.upper_bound(position);
  if (after == checkpoints_.begin()) {
    run_.emplace(Run::create(header_.program, header_.arguments, header_.budgets).value());
  } else {
    run_.emplace(std::prev(after)->second);
  }
  semantics::NoRecorder none;
  for (std::size_t done = run_->position(); done < position; ++done) {
    if (done % interval_ == 0 && done > 0) checkpoints_.try_emplace(done, *run_);
    apply(*run_, journal[done], none, -1);
    run_->take_calls();
    run_->take_printed();
  }
  if (checkpoints_.size() > kCheckpoints) {
    interval_ *= 2;
    std::erase_if(checkpoints_, [this](const auto& each) { return each.first % interval_ != 0; });
  }
  return *run_;
}

List Replay::steps(const std::vector<JournalEntry>& journal, std::size_t from, std::size_t to, int micro) {
  Run& run = at(journal, from - 1);
  List steps;
  for (std::size_t step = from; step <= to; ++step) {
    const JournalEntry& entry = journal[step - 1];
    const bool partial = step == journal.size() && micro >= 0;
    semantics::TreeRecorder recorder;
    apply(run, entry, recorder, partial ? micro : -1);
    Value json = trace_step(run, recorder.derivation, input_json(*header_.program, entry), step, run.take_calls());
    if (partial) json.mutable_dict().set("complete", false);
    steps.push_back(std::move(json));
  }
  return steps;
}

Value Replay::why(const std::vector<JournalEntry>& journal, std::size_t step, int micro, semantics::PortId port) {
  Run& run = at(journal, step - 1);
  semantics::NoRecorder none;
  apply(run, journal[step - 1], none, micro);
  return why_json(run, port);
}

Value call_json(const semantics::OutgoingCall& call) {
  return Dict{{"call", static_cast<std::int64_t>(call.number)},
              {"service", call.service},
              {"operation", call.name},
              {"args", call.args},
              {"kwargs", call.kwargs}};
}

Value trace_step(const Run& run, const semantics::Derivation& derivation, Value input, std::size_t step,
                 const std::vector<semantics::OutgoingCall>& calls) {
  List micro, out;
  for (std::size_t i = 0; i < derivation.micro.size(); ++i)
    micro.push_back(semantics::derivation_json(run.program(), derivation, i));
  for (const semantics::OutgoingCall& call : calls) out.push_back(call_json(call));
  return Dict{{"step", static_cast<std::int64_t>(step)},
              {"input", std::move(input)},
              {"micro", std::move(micro)},
              {"calls", std::move(out)},
              {"state", run.state_json()}};
}

}  // namespace race::server
