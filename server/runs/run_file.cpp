#include "server/runs/run_file.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "core/execution/checkpoint.h"
#include "core/execution/journal_walk.h"
#include "core/execution/step_json.h"
#include "core/rcm/document.h"
#include "core/rcm/ids.h"
#include "core/rsm/document.h"
#include "core/value/base64.h"
#include "core/value/error_list.h"
#include "core/value/fields.h"
#include "core/value/json.h"
#include "server/runs/run_json.h"
#include "server/store/journal_chain.h"
#include "server/store/journal_writer.h"
#include "server/wire/pose_json.h"

namespace race::server {
namespace {

using Errors = std::vector<Error>;

// Work that a file may ask for when it is opened.
constexpr std::uint64_t kMostMicroSteps = 4'000'000;
constexpr std::uint64_t kCheckpointInterval = 256, kMostCheckpoints = 64;

tl::unexpected<Errors> one(Error error) { return tl::unexpected(Errors{std::move(error)}); }

tl::unexpected<Error> corrupt(const std::string& what, std::string path) {
  return unexpected(ErrorCode::corrupt, what, std::move(path));
}

/// A whole number from 0; 0 (a violation) if it is another.
std::int64_t read_count(Fields& fields, std::string_view key, Fields::Need need = kRequired) {
  const Value* number = fields.find(key, need);
  if (!number) return 0;
  if (number->is_integer() && number->as_integer() >= 0) return number->as_integer();
  fields.violation(ErrorCode::out_of_range, "`" + std::string(key) + "` must be an integer from 0", key);
  return 0;
}

bool is_status(const std::string& status) {
  constexpr std::array kStatus = {"ready", "running", "interrupted", "ended", "faulted", "aborted"};
  return std::ranges::find(kStatus, status) != kStatus.end();
}

/// schemas/run.json, and the chain that it has. What follows from the journal is held against it later.
std::pair<RunRecord, std::string> read_record(const Value& json, Errors& errors) {
  RunRecord run;
  Fields fields(json, "run", "the run", errors, kByField);
  fields.text("id", kRequired);
  run.document = fields.text("document", kRequired).value_or("");
  if (!rcm::is_id(run.document)) fields.violation(ErrorCode::name, "`document` must be the name of one", "document");
  run.revision = read_count(fields, "revision");
  const Value arguments = fields.constant("arguments", kRequired).value_or(Dict());
  if (arguments.is_dict()) run.arguments = arguments.as_dict();
  run.status = fields.text("status", kRequired).value_or("ready");
  if (!is_status(run.status)) fields.violation(ErrorCode::type, "`status` must be that of a run", "status");
  run.outcome = fields.text("outcome").value_or("");
  run.fault = fields.constant("fault").value_or(Value());
  run.results = fields.constant("results").value_or(Value());
  run.steps = static_cast<std::uint64_t>(read_count(fields, "steps"));
  const std::string chain = fields.text("chain", kRequired).value_or("");
  run.created_ms = read_count(fields, "created");
  run.ended_ms = read_count(fields, "ended", Fields::Need::optional);
  if (fields.find("imported", kRequired)) fields.boolean("imported");
  read_count(fields, "bytes");
  fields.close();
  return {std::move(run), chain};
}

std::map<std::string, rsm::Service> read_services(Fields& file, Errors& errors) {
  std::map<std::string, rsm::Service> services;
  const Value* json = file.find("services", kRequired);
  if (!json) return services;
  if (!json->is_dict()) file.violation(ErrorCode::type, "`services` must be an object", "services");
  if (!json->is_dict()) return services;
  for (const auto& [key, text] : json->as_dict()) {
    const std::string path = "services/" + key.as_string();
    for (const char* needed : {"rsm", "name", "operations", "events"})
      if (text.is_dict() && !text.find(needed))
        add_error(errors, {ErrorCode::missing, "a service has `" + std::string(needed) + "`", path + '/' + needed});
    auto service = rsm::read_service(text, path);
    if (service)
      services.emplace(key.as_string(), std::move(*service));
    else
      append_below(errors, std::move(service).error(), "");
  }
  return services;
}

/// The entries of an object, each as `is_good` says.
void check_entries(Fields& fields, const char* key, bool (*is_good)(const Value&), const char* expected) {
  const Value* entries = fields.find(key, kRequired);
  if (!entries) return;
  if (!entries->is_dict())
    return fields.violation(ErrorCode::type, "`" + std::string(key) + "` must be an object", key);
  for (const auto& [name, value] : entries->as_dict())
    if (!is_good(value))
      fields.violation(ErrorCode::type, std::string("must be ") + expected, std::string(key) + '/' + name.as_string());
}

/// schemas/cell_pose.json of any world.
void check_pose(const Value& json, const std::string& path, Errors& errors) {
  Fields fields(json, path, "a pose", errors, kByField);
  if (!fields.number("time")) fields.violation(ErrorCode::missing, "a pose has a `time`", "time");
  check_entries(fields, "joints", is_number, "a number");
  check_entries(fields, "bodies", is_pose, "a pose");
  if (fields.find("hands") && !std::ranges::all_of(fields.list("hands"), is_touch))
    fields.violation(ErrorCode::type, "`hands` must be hands and pushes", "hands");
  fields.close();
}

std::vector<Sample> read_samples(Fields& file, Errors& errors) {
  std::vector<Sample> samples;
  const List& list = file.list("samples", kRequired);
  if (list.size() > Samples::kMost) {
    file.violation(ErrorCode::too_large, "at most " + std::to_string(Samples::kMost) + " samples", "samples");
    return samples;
  }
  for (const Value& json : list) {
    const std::string path = "samples/" + std::to_string(samples.size());
    Fields fields(json, path, "a sample", errors, kByField);
    Sample sample;
    sample.step = static_cast<std::uint64_t>(read_count(fields, "step"));
    sample.pose = fields.constant("pose", kRequired).value_or(Dict());
    fields.close();
    check_pose(sample.pose, path + "/pose", errors);
    if (deeper_than(sample.pose, JsonLimits{}.depth))
      add_error(errors, {ErrorCode::too_deep, "a pose is not so deep", path + "/pose"});
    sample.pose.freeze();
    samples.push_back(std::move(sample));
  }
  return samples;
}

/// A picture as a browser can show it; whether it is one is for the browser to see.
Picture read_picture(const Value& json, const std::string& path, Errors& errors) {
  Fields fields(json, path, "a picture", errors, kByField);
  Picture picture;
  picture.service = fields.text("service", kRequired).value_or("");
  if (picture.service.size() > Pictures::kLongestService)
    fields.violation(ErrorCode::too_large, "a key has at most " + std::to_string(Pictures::kLongestService) + " bytes",
                     "service");
  picture.step = static_cast<std::uint64_t>(read_count(fields, "step"));
  const std::optional<double> time = fields.number("time");
  if (!time) fields.violation(ErrorCode::missing, "a picture has a `time`", "time");
  picture.time = time.value_or(0);
  picture.jpeg = fields.text("jpeg", kRequired).value_or("");
  if (picture.jpeg.size() > Pictures::kLongest)
    fields.violation(ErrorCode::too_large, "at most " + std::to_string(Pictures::kLongest) + " characters", "jpeg");
  if (!is_base64(picture.jpeg)) fields.violation(ErrorCode::type, "`jpeg` must be base64", "jpeg");
  fields.close();
  return picture;
}

std::vector<Picture> read_pictures(Fields& file, Errors& errors) {
  std::vector<Picture> pictures;
  const List& list = file.list("pictures");
  if (list.size() > Pictures::kMost) {
    file.violation(ErrorCode::too_large, "at most " + std::to_string(Pictures::kMost) + " pictures", "pictures");
    return pictures;
  }
  for (const Value& json : list)
    pictures.push_back(read_picture(json, "pictures/" + std::to_string(pictures.size()), errors));
  return pictures;
}

/// What is said of times, which follows from nothing else.
std::vector<TimingBlock> read_timing_blocks(Fields& file, std::uint64_t steps, Errors& errors) {
  std::vector<TimingBlock> blocks;
  const List& list = file.list("timing");
  if (list.size() > TimingBlock::kMostBlocks) {
    file.violation(ErrorCode::too_large, "at most " + std::to_string(TimingBlock::kMostBlocks) + " blocks", "timing");
    return blocks;
  }
  for (const Value& json : list) {
    const std::string path = "timing/" + std::to_string(blocks.size());
    blocks.push_back(read_timing(json, path, errors));
    if (!blocks.back().steps.empty() && blocks.back().last() > steps)
      add_error(errors,
                {ErrorCode::out_of_range, "the run has " + std::to_string(steps) + " macro steps", path + "/first"});
  }
  return blocks;
}

/// Budgets beyond ours would let a file keep a thread busy.
Expected<void> check_budgets(const semantics::Budgets& budgets) {
  const semantics::Budgets ours;
  if (budgets.micro_steps <= ours.micro_steps && budgets.evaluation.steps <= ours.evaluation.steps &&
      budgets.evaluation.value_units <= ours.evaluation.value_units && budgets.work <= ours.work &&
      budgets.calls <= ours.calls && budgets.output_units <= ours.output_units && budgets.data_units <= ours.data_units)
    return {};
  return unexpected(ErrorCode::out_of_range, "the budgets are beyond those of this server", "journal/header/budgets");
}

/// What the run came to is what the journal says, else `corrupt`. A file may have been written in the macro step that
/// ended the run: then it is over.
Expected<void> check_outcome(const execution::Execution& execution, RunRecord& run) {
  const semantics::Run& ours = execution.run();
  const std::string status(semantics::name(ours.status()));
  if (!execution.is_over() && !run.is_over()) return {};
  if (!run.is_over()) {
    run.status = status;
    run.outcome = ours.outcome();
    run.fault = ours.fault() ? execution::fault_json(*ours.fault()) : Value();
    run.results = execution::root_results(ours);
    return {};
  }
  if (run.status != status) return corrupt("the journal says that the run is " + status, "run/status");
  if (run.status == "ended" && run.outcome != ours.outcome())
    return corrupt("the journal says that the outcome is " + ours.outcome(), "run/outcome");
  if (ours.fault() && run.fault != execution::fault_json(*ours.fault()))
    return corrupt("the journal says that the run has another fault", "run/fault");
  if (run.results != execution::root_results(ours))
    return corrupt("the journal says that the run has other results", "run/results");
  return {};
}

/// Does the run again; every so many macro steps, a checkpoint.
Expected<void> check_replay(RunFile& file, std::map<std::uint64_t, std::string>* checkpoints,
                            const std::atomic<bool>* stop, WorkProgress* progress) {
  const std::uint64_t steps = file.journal.entries.size();
  if (progress) progress->begin(2 * steps, "entries");  // part_of_storing() is the other half
  const WorkPart done_again(progress, 0, steps);
  const std::uint64_t interval = std::max(kCheckpointInterval, steps / kMostCheckpoints + 1);
  execution::JournalHeader header = file.journal.header;
  header.budgets.evaluation.stop = stop;
  ASSIGN_OR_RETURN(
      execution::JournalWalk walk,
      execution::JournalWalk::create(header, std::make_shared<execution::MemoryJournal>(file.journal.entries), steps));
  for (std::uint64_t micro_steps = 0; !walk.at_end();) {
    auto progress = walk.next({.entry = false});
    if (stop && *stop) return unexpected(ErrorCode::unavailable, "the run is not done again to its end");
    if (!progress)
      return unexpected(progress.error().code, progress.error().message, "journal/" + progress.error().path);
    micro_steps += (*progress)->micro;
    if (micro_steps > kMostMicroSteps)
      return unexpected(ErrorCode::too_large,
                        "the run has more than " + std::to_string(kMostMicroSteps) + " micro steps", "journal");
    const std::uint64_t position = walk.execution().run().position();
    done_again.reach(position, steps);
    if (checkpoints && position % interval == 0 && !walk.execution().is_over()) {
      std::string text = to_json(execution::checkpoint_json(walk.execution()));
      if (text.size() <= RunJournal::kCheckpointBytes) checkpoints->emplace(position, std::move(text));
    }
  }
  return check_outcome(walk.execution(), file.record);
}

/// The record against the journal.
Expected<void> check(RunFile& file, const std::string& chain, std::map<std::uint64_t, std::string>* checkpoints,
                     const std::atomic<bool>* stop, WorkProgress* progress) {
  const execution::Journal& journal = file.journal;
  if (file.record.steps != journal.entries.size())
    return corrupt("the journal has " + std::to_string(journal.entries.size()) + " entries", "run/steps");
  if (Value(file.record.arguments) != Value(journal.header.arguments))
    return corrupt("the journal has other arguments", "run/arguments");
  sqlite::Digest ours = header_chain(journal.header);
  for (const execution::JournalEntry& entry : journal.entries) ours = chain_after(ours, input_text(entry));
  if (sqlite::hex(ours) != chain) return corrupt("the chain is not that of the journal", "run/chain");
  if (auto within = check_budgets(journal.header.budgets); !within) return within;
  return check_replay(file, checkpoints, stop, progress);
}

}  // namespace

tl::unexpected<Error> beyond_file_limits() {
  return unexpected(ErrorCode::too_large,
                    "more than " + std::to_string(kRunFileLimits.bytes) +
                        " bytes; `race replay RUN --data DIR` reads the run where it is stored, and "
                        "/api/v1/runs/RUN/derivations?from&to gives it in parts");
}

Expected<std::string> bounded_text(const Value& json) {
  std::string text = to_json(json);
  if (text.size() > kRunFileLimits.bytes) return beyond_file_limits();
  return text;
}

Expected<std::string> write_run_file(const RunFile& file) {
  Dict services;
  for (const auto& [key, service] : file.services) services.set(key, rsm::write_service(service));
  Dict json{
      {"version", kRunFileVersion}, {"run", run_json(file.record)}, {"journal", execution::journal_json(file.journal)}};
  if (file.document) json.set("document", *file.document);
  json.set("services", std::move(services));
  json.set("samples", samples_json(file.samples));
  // What there may be no room for, the dearest last.
  std::vector<Dict> richer{std::move(json)};
  const auto add = [&](const char* field, List list) {
    if (list.empty()) return;
    richer.push_back(richer.back());
    richer.back().set(field, std::move(list));
  };
  List timing, pictures;
  for (const TimingBlock& block : file.timing) timing.push_back(timing_json(block));
  for (const Picture& picture : file.pictures) pictures.push_back(picture_json(picture));
  add("timing", std::move(timing));
  add("pictures", std::move(pictures));
  for (; richer.size() > 1; richer.pop_back())
    if (auto text = bounded_text(richer.back())) return text;
  return bounded_text(richer.back());
}

bool is_run_file(const Value& json) { return json.find("journal") != nullptr || json.find("run") != nullptr; }

Checked<RunFile> read_run_file_text(std::string_view text, std::map<std::uint64_t, std::string>* checkpoints,
                                    const std::atomic<bool>* stop, WorkProgress* progress) {
  auto json = parse_json(text, kRunFileLimits);
  if (!json) return one(std::move(json).error());
  return read_run_file(*json, checkpoints, stop, progress);
}

Checked<RunFile> read_run_file(const Value& json, std::map<std::uint64_t, std::string>* checkpoints,
                               const std::atomic<bool>* stop, WorkProgress* progress) {
  Errors errors;
  RunFile file;
  Fields fields(json, "", "the file of a run", errors, kByField);
  const Value* version = fields.find("version", kRequired);
  if (version && *version != Value(kRunFileVersion))
    return one({ErrorCode::version, "`version` must be " + std::to_string(kRunFileVersion), "version"});
  const Value* run = fields.find("run", kRequired);
  const Value* journal = fields.find("journal", kRequired);
  std::string chain;
  if (run) std::tie(file.record, chain) = read_record(*run, errors);
  file.document = fields.constant("document");
  if (file.document)
    if (auto document = rcm::read_document(*file.document); !document)
      append_below(errors, std::move(document).error(), "document");
  file.services = read_services(fields, errors);
  file.samples = read_samples(fields, errors);
  file.timing = read_timing_blocks(fields, file.record.steps, errors);
  file.pictures = read_pictures(fields, errors);
  fields.close();
  if (journal) {
    auto read = execution::read_journal(*journal);
    if (read)
      file.journal = std::move(*read);
    else
      append_below(errors, std::move(read).error(), "journal");
  }
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  if (auto checked = check(file, chain, checkpoints, stop, progress); !checked) return one(std::move(checked).error());
  return file;
}

}  // namespace race::server
