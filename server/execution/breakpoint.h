// Breakpoints of a core: goals that stay, each of the person who has set it.
#pragma once

#include <string>
#include <vector>

#include "core/execution/goal.h"
#include "server/execution/goal_json.h"

namespace race::server {

struct Breakpoint {
  execution::GoalName goal;
  std::string author = {};  // empty: nobody said who
};

/// As schemas/core.json has them.
inline List breakpoints_json(const std::vector<Breakpoint>& breakpoints) {
  List list;
  for (const Breakpoint& each : breakpoints) {
    Dict json = goal_json(each.goal).as_dict();
    if (!each.author.empty()) json.set("author", each.author);
    list.push_back(std::move(json));
  }
  return list;
}

}  // namespace race::server
