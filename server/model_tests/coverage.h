// Coverage: which states of a document were active, which ports fired, and which conditions of ports and actions were
// looked at while they held and while they did not. What translation makes of links counts for what it is made of.
#pragma once

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
  /// {"states": {"covered", "all", "missing": [...]}, "ports", "conditions"}; a missing value of a condition is named
  /// with what it was not: "Root/A.done never true".
  Value json() const;

 private:
  friend class CoverageOfRun;
  std::map<std::string, bool> states_, ports_;
  std::map<std::string, Condition> conditions_;  // by port, or "Root/A action 1"
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
