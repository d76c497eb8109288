// Coverage: which states of a document were active, which ports fired, and which conditions of ports and actions were
// looked at while they held and while they did not. What translation makes of links counts for what it is made of.
#pragma once

#include <compare>
#include <map>
#include <string>
#include <vector>

#include "core/execution/execution.h"
#include "core/value/value.h"

namespace race::server {

class Coverage {
 public:
  /// Path in the native model -> path in the document (rcm::NativeModel).
  using Origin = std::map<std::string, std::string>;
  /// Of a port, "Root/A.done", or of the action of this number, from 1, of a state, "Root/A".
  struct ConditionPlace {
    std::string at;
    std::size_t action = 0;  // 0: of a port
    auto operator<=>(const ConditionPlace&) const = default;
  };
  struct Condition {
    bool held = false, failed = false;  // failed: while its state was active it was false, or unknown
  };
  struct Count {
    std::size_t covered = 0, all = 0;
  };

  /// Adds the elements of a program, none of them covered. `library`: the state of the library that is its root.
  void add(const semantics::Program& program, const Origin& origin, const std::string& library = {});

  Count states() const;
  Count ports() const;
  /// Of values of conditions: two each.
  Count conditions() const;
  /// Schemas/test_report.json, `model_coverage`: counts, and what is covered and what is missing.
  Value json() const;

 private:
  friend class CoverageOfRun;
  std::map<std::string, bool> states_, ports_;
  std::map<ConditionPlace, Condition> conditions_;
};

/// Notes in a Coverage what one run comes to.
class CoverageOfRun {
 public:
  /// As Coverage::add(), which it calls. The coverage outlives it.
  CoverageOfRun(Coverage& coverage, const semantics::Program& program, const Coverage::Origin& origin,
                const std::string& library);

  /// Looks at a run of this program: between two of its micro steps, or two macro steps.
  void look(const execution::Execution& execution);
  /// A port has fired.
  void fired(const semantics::Program& program, const std::string& port);

 private:
  std::vector<bool*> states_, ports_;  // by number; nullptr: nothing of the document
  std::vector<Coverage::Condition*> port_conditions_, action_conditions_;
};

}  // namespace race::server
