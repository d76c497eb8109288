#include "server/model_tests/expectations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "core/value/json.h"

namespace race::server {
namespace {

constexpr std::size_t kListed = 12;  // of what was seen, in a message

std::string seconds(double time) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3f s", time);
  return text.data();
}

bool matches_call(const ExpectedCall& expected, const SeenCall& seen, double tolerance) {
  if (expected.service != seen.service || expected.operation != seen.operation) return false;
  if (expected.args && !matches(*expected.args, seen.args, tolerance)) return false;
  return matches(expected.kwargs, seen.kwargs, tolerance);
}

// As a task writes it: robot.move([0, 1], speed=0.5).
std::string call_text(const std::string& service, const std::string& operation, const List& args, const Dict& kwargs) {
  std::string inner;
  for (const Value& each : args) inner += (inner.empty() ? "" : ", ") + to_json(each);
  for (const auto& [key, value] : kwargs) inner += (inner.empty() ? "" : ", ") + key.as_string() + "=" + to_json(value);
  return service + "." + operation + "(" + inner + ")";
}

std::string text_of(const ExpectedCall& call) {
  if (!call.args && call.kwargs.empty()) return call.service + "." + call.operation;
  return call_text(call.service, call.operation, call.args.value_or(List{}), call.kwargs);
}

std::string text_of(const SeenCall& call) {
  return call_text(call.service, call.operation, call.args, call.kwargs) + " at " + seconds(call.time);
}

std::string text_of(const FiredPort& port) { return port.port + " at " + seconds(port.time); }

// The last of what was seen: what led to where it ended.
template <typename T>
std::string last_of(const std::vector<T>& all) {
  if (all.empty()) return "none";
  std::string text = all.size() > kListed ? "..." : "";
  for (std::size_t i = all.size() - std::min(all.size(), kListed); i < all.size(); ++i)
    text += (text.empty() ? "" : ", ") + text_of(all[i]);
  return text;
}

std::string end_of(const Observed& seen) {
  if (seen.status == "ended") return "it ended at `" + seen.outcome + "`";
  if (seen.status == "faulted") return "it faulted: " + seen.fault;
  return "it was still running";
}

class Comparison {
 public:
  Comparison(const Expectation& expect, const Observed& seen, const std::string& path)
      : expect_(expect), seen_(seen), path_(path + "/expect/") {}

  std::vector<Finding> all() {
    check_end();
    check_order();
    check_ports("fired", expect_.fired, true);
    check_ports("not_fired", expect_.not_fired, false);
    check_calls();
    check_not_called();
    check_results();
    return std::move(found_);
  }

 private:
  void add(const std::string& where, std::string message) { found_.push_back({path_ + where, std::move(message)}); }

  void check_end() {
    const std::string end = end_of(seen_) + " at " + seconds(seen_.time);
    const std::string ports = "; ports that fired: " + last_of(seen_.ports);
    if (expect_.outcome && (seen_.status != "ended" || seen_.outcome != *expect_.outcome))
      add("outcome", "expected `" + *expect_.outcome + "`, but " + end + ports);
    if (expect_.status && seen_.status != *expect_.status)
      add("status", "expected `" + *expect_.status + "`, but " + end + ports);
    if (expect_.within && (seen_.status == "running" || seen_.time > *expect_.within))
      add("within", "expected an end within " + seconds(*expect_.within) + ", but " + end);
  }

  void check_order() {
    auto from = seen_.ports.begin();
    for (std::size_t i = 0; i < expect_.order.size(); ++i) {
      from = std::ranges::find(from, seen_.ports.end(), expect_.order[i], &FiredPort::port);
      if (from == seen_.ports.end())
        return add("order/" + std::to_string(i), "`" + expect_.order[i] + "` did not fire" +
                                                     (i > 0 ? " after `" + expect_.order[i - 1] + "`" : std::string()) +
                                                     "; ports that fired: " + last_of(seen_.ports));
      ++from;
    }
  }

  void check_ports(const std::string& where, const std::vector<std::string>& ports, bool expected) {
    for (std::size_t i = 0; i < ports.size(); ++i) {
      const auto fired = std::ranges::find(seen_.ports, ports[i], &FiredPort::port);
      if ((fired != seen_.ports.end()) == expected) continue;
      add(where + "/" + std::to_string(i),
          expected ? "`" + ports[i] + "` did not fire; ports that fired: " + last_of(seen_.ports)
                   : "`" + ports[i] + "` fired at " + seconds(fired->time));
    }
  }

  void check_calls() {
    auto from = seen_.calls.begin();
    for (std::size_t i = 0; i < expect_.calls.size(); ++i) {
      const ExpectedCall& expected = expect_.calls[i];
      from = std::find_if(from, seen_.calls.end(),
                          [&](const SeenCall& call) { return matches_call(expected, call, expect_.tolerance); });
      if (from == seen_.calls.end())
        return add("calls/" + std::to_string(i),
                   "no call " + text_of(expected) +
                       (i > 0 ? " after " + text_of(expect_.calls[i - 1]) : std::string()) +
                       "; calls: " + last_of(seen_.calls));
      ++from;
    }
  }

  void check_not_called() {
    for (std::size_t i = 0; i < expect_.not_called.size(); ++i) {
      const auto found = std::ranges::find_if(seen_.calls, [&](const SeenCall& call) {
        return matches_call(expect_.not_called[i], call, expect_.tolerance);
      });
      if (found != seen_.calls.end()) add("not_called/" + std::to_string(i), "there was the call " + text_of(*found));
    }
  }

  void check_results() {
    for (const auto& [name, expected] : expect_.results) {
      const Value* value = seen_.results.find(name);
      if (value && matches(expected, *value, expect_.tolerance)) continue;
      add("results/" + name.as_string(),
          "expected " + to_json(expected) + ", got " + (value ? to_json(*value) : std::string("no value")));
    }
  }

  const Expectation& expect_;
  const Observed& seen_;
  std::string path_;
  std::vector<Finding> found_;
};

bool matches_list(const List& expected, const List& seen, double tolerance) {
  return std::ranges::equal(expected, seen, [&](const Value& a, const Value& b) { return matches(a, b, tolerance); });
}

bool matches_dict(const Dict& expected, const Dict& seen, double tolerance) {
  return std::ranges::all_of(expected, [&](const auto& entry) {
    const Value* found = seen.find(entry.first);
    return found && matches(entry.second, *found, tolerance);
  });
}

}  // namespace

bool matches(const Value& expected, const Value& seen, double tolerance) {
  if (expected.is_numeric() && seen.is_numeric())
    return expected == seen || std::abs(expected.to_double() - seen.to_double()) <= tolerance;
  if (expected.is_list() && seen.is_list()) return matches_list(expected.as_list(), seen.as_list(), tolerance);
  if (expected.is_dict() && seen.is_dict()) return matches_dict(expected.as_dict(), seen.as_dict(), tolerance);
  return expected == seen;
}

std::vector<Finding> unmet_expectations(const Expectation& expect, const Observed& seen, const std::string& path) {
  return Comparison(expect, seen, path).all();
}

}  // namespace race::server
