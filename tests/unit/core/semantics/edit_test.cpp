// Carrying a run over to an edited program, and forcing values and ports (core/SEMANTICS.md section 9), on small models.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/core/semantics/small_runs.h"

namespace race::semantics {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// The program of a root that is written as for SmallRun.
std::shared_ptr<const Program> program_of(const std::string& root) {
  SmallRun run(root);
  return run->shared_program();
}

struct Edited {
  Edited(SmallRun& before, const std::string& root) : result(before->edited(program_of(root))) {}
  std::vector<std::string> waits() const {
    std::vector<std::string> out;
    if (!result)
      for (const Obstacle& each : result.error())
        out.push_back(each.path + (each.parameter.empty() ? "" : " par." + each.parameter));
    return out;
  }
  Value value(const char* group, const char* path, const char* name) const {
    const Value state = result->state_json();
    const Value* node = state.find(group)->find(path);
    const Value* found = node ? node->find(name) : nullptr;
    return found ? *found : Value::unknown();
  }
  std::string active() const {
    std::string out;
    const Value state = result->state_json();
    for (const Value& path : state.find("active")->as_list()) out += (out.empty() ? "" : " ") + path.as_string();
    return out;
  }
  tl::expected<Run, std::vector<Obstacle>> result;
};

}  // namespace
}  // namespace race::semantics
