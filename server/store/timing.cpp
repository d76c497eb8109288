#include "server/store/timing.h"

#include <utility>

#include "core/value/error_list.h"
#include "core/value/fields.h"

namespace race::server {
namespace {

using Errors = std::vector<Error>;

constexpr std::int64_t kMostTime = std::int64_t{1} << 53U;  // [us], and the largest number of a macro step

Value number_json(std::uint64_t n) { return static_cast<std::int64_t>(n); }

// At the end of its macro step: -1.
void add_moment(List& list, const Moment& moment) {
  list.push_back(number_json(moment.step));
  list.push_back(moment.micro == Moment::kEnd ? Value(-1) : number_json(moment.micro));
}

List moment_json(const Moment& moment) {
  List list;
  add_moment(list, moment);
  return list;
}

List arrival_json(const Arrival& arrival) {
  List list{Value(arrival.time)};
  add_moment(list, arrival.moment);
  return list;
}

/// Reads integers of a list in which each has its place.
class Numbers {
 public:
  Numbers(const Value& json, std::string path, Errors& errors) : path_(std::move(path)), errors_(errors) {
    if (json.is_list())
      list_ = &json.as_list();
    else
      fail(ErrorCode::type, "must be a list of integers");
  }
  std::size_t size() const { return list_ ? list_->size() : 0; }
  /// Whether there are so many.
  void require_size(std::size_t size) {
    if (list_ && list_->size() != size) fail(ErrorCode::type, "must have " + std::to_string(size) + " integers");
  }
  std::int64_t next(std::int64_t least = 0, std::int64_t most = kMostTime) {
    if (!list_ || next_ >= list_->size()) return std::max<std::int64_t>(least, 0);
    const Value& value = (*list_)[next_++];
    if (value.is_integer() && value.as_integer() >= least && value.as_integer() <= most) return value.as_integer();
    fail(value.is_integer() ? ErrorCode::out_of_range : ErrorCode::type,
         "must have integers from " + std::to_string(least) + " to " + std::to_string(most));
    return std::max<std::int64_t>(least, 0);
  }
  Moment next_moment() {
    Moment moment;
    moment.step = static_cast<std::uint64_t>(next());
    const std::int64_t micro = next(-1, Moment::kEnd - 1);
    moment.micro = micro < 0 ? Moment::kEnd : static_cast<std::uint32_t>(micro);
    return moment;
  }
  Arrival next_arrival() {
    const std::int64_t time = next();
    return {time, next_moment()};
  }

 private:
  void fail(ErrorCode code, const char* what) { fail(code, std::string(what)); }
  void fail(ErrorCode code, std::string what) { add_error(errors_, {code, std::move(what), path_}); }

  const List* list_ = nullptr;
  std::size_t next_ = 0;
  std::string path_;
  Errors& errors_;
};

StepTime read_step(const Value& json, const std::string& path, Errors& errors) {
  Numbers numbers(json, path, errors);
  StepTime step;
  if (numbers.size() != 1) numbers.require_size(4);
  step.time = numbers.next();
  if (numbers.size() == 4) step.input = numbers.next_arrival();
  return step;
}

Moment read_moment(const Value* json, const std::string& path, Errors& errors) {
  if (!json) return {};
  Numbers numbers(*json, path, errors);
  numbers.require_size(2);
  return numbers.next_moment();
}

Undelivered read_undelivered(const Value& json, const std::string& path, Errors& errors) {
  static const execution::JournalEntry kStart = execution::StartEntry{};
  Fields fields(json, path, "an input", errors, kByField);
  Undelivered read;
  if (const Value* input = fields.find("input", kRequired)) {
    auto entry = execution::read_input(*input, &kStart);
    if (!entry) {
      append_below(errors, std::move(entry).error(), path);
    } else {
      read.input = std::move(*entry);
      if (!std::holds_alternative<execution::EventEntry>(read.input) &&
          !std::holds_alternative<execution::ResponseEntry>(read.input))
        fields.violation(ErrorCode::type, "`input` must be an event or a response", "input");
    }
  }
  if (const Value* arrival = fields.find("arrival", kRequired)) {
    Numbers numbers(*arrival, path + "/arrival", errors);
    numbers.require_size(3);
    read.arrival = numbers.next_arrival();
  }
  read.dropped = read_moment(fields.find("dropped", kRequired), path + "/dropped", errors);
  fields.close();
  return read;
}

ServiceChange read_change(const Value& json, const std::string& path, Errors& errors) {
  Fields fields(json, path, "a state of a service", errors, kByField);
  ServiceChange change;
  change.time = fields.integer("time", 0, kMostTime, kRequired).value_or(0);
  change.service = fields.text("service", kRequired).value_or("");
  change.state = fields.text("state");
  for (const std::string& name : {change.service, change.state.value_or("")})
    if (name.size() > TimingBlock::kLongestName)
      fields.violation(ErrorCode::too_large,
                       "a name has at most " + std::to_string(TimingBlock::kLongestName) + " bytes");
  fields.close();
  return change;
}

/// The items of the list `key`, each read by `read`.
template <typename Item>
std::vector<Item> read_list(Fields& fields, const char* key, std::size_t most,
                            Item (*read)(const Value&, const std::string&, Errors&), Errors& errors) {
  const List& list = fields.list(key, kRequired);
  std::vector<Item> items;
  if (list.size() > most) {
    fields.violation(ErrorCode::too_large, "at most " + std::to_string(most) + " in `" + key + "`", key);
    return items;
  }
  const std::string path = fields.path() + "/" + key + "/";
  for (const Value& json : list) items.push_back(read(json, path + std::to_string(items.size()), errors));
  return items;
}

}  // namespace

Value timing_json(const TimingBlock& block) {
  List steps, undelivered, services;
  for (const StepTime& step : block.steps) {
    List list{Value(step.time)};
    if (step.input) list = arrival_json(*step.input), list.insert(list.begin(), Value(step.time));
    steps.emplace_back(std::move(list));
  }
  for (const Undelivered& each : block.undelivered)
    undelivered.emplace_back(Dict{{"input", execution::input_json(each.input)},
                                  {"arrival", arrival_json(each.arrival)},
                                  {"dropped", moment_json(each.dropped)}});
  for (const ServiceChange& change : block.services) {
    Dict json{{"time", change.time}, {"service", change.service}};
    if (change.state) json.set("state", *change.state);
    services.emplace_back(std::move(json));
  }
  return Dict{{"first", number_json(block.first)},
              {"steps", std::move(steps)},
              {"begins", block.begins},
              {"ends", block.ends},
              {"since", moment_json(block.since)},
              {"until", moment_json(block.until)},
              {"undelivered", std::move(undelivered)},
              {"services", std::move(services)}};
}

TimingBlock read_timing(const Value& json, const std::string& path, Errors& errors) {
  Fields fields(json, path, "a block of times", errors, kByField);
  TimingBlock block;
  block.first = static_cast<std::uint64_t>(fields.integer("first", 1, kMostTime, kRequired).value_or(1));
  block.steps = read_list(fields, "steps", TimingBlock::kMostSteps, read_step, errors);
  block.begins = fields.integer("begins", 0, kMostTime, kRequired).value_or(0);
  block.ends = fields.integer("ends", 0, kMostTime, kRequired).value_or(0);
  block.since = read_moment(fields.find("since", kRequired), path + "/since", errors);
  block.until = read_moment(fields.find("until", kRequired), path + "/until", errors);
  block.undelivered = read_list(fields, "undelivered", TimingBlock::kMostUndelivered, read_undelivered, errors);
  block.services = read_list(fields, "services", TimingBlock::kMostChanges, read_change, errors);
  fields.close();
  return block;
}

}  // namespace race::server
