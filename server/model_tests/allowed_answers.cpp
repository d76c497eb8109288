#include "server/model_tests/allowed_answers.h"

#include <algorithm>
#include <deque>
#include <set>
#include <utility>

namespace race::server {

std::vector<AllowedAnswer> allowed_answers(const rsm::Service& service, const rsm::Instance& instance,
                                           std::uint64_t call) {
  struct Place {
    rsm::Instance instance;
    std::vector<std::string> way;
  };
  std::vector<AllowedAnswer> found;
  std::set<std::string> seen = {instance.current};
  std::deque<Place> open;
  open.push_back({instance, {}});
  while (!open.empty()) {
    const Place place = std::move(open.front());
    open.pop_front();
    for (const rsm::Transition& t : service.transitions) {
      if (t.operation) continue;
      Place next = place;
      const std::uint64_t answered = rsm::answers_one(service, next.instance, t, call) ? call : 0;  // R25
      const auto effect = rsm::Trans2(service, next.instance, t.id, answered);
      if (!effect) continue;
      next.way.push_back(t.id);
      const auto answer = std::ranges::find(effect->answers, call, &rsm::Answer::call);
      if (answer != effect->answers.end())
        found.push_back({next.way, answer->is_error, answer->error_code});
      else if (effect->answers.empty() && seen.insert(next.instance.current).second)
        open.push_back(std::move(next));
    }
  }
  return found;
}

bool is_pending(const rsm::Instance& instance, std::uint64_t call) {
  return std::ranges::any_of(
      instance.pending, [&](const auto& entry) { return std::ranges::find(entry.second, call) != entry.second.end(); });
}

}  // namespace race::server
