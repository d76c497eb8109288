// OperationTable: what a component offers, in one table: its operations with their handlers, and the transitions by
// which its states accept them. The component's RSM is made from the table, and TableComponent (table_component.h)
// accepts and rejects calls by it.
//
// Threads: immutable once it is made; any.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/rsm/model.h"
#include "core/value/value.h"
#include "services/component.h"

namespace race::services {

class TableComponent;

/// The code of an operation: a member function of the component. One with a second parameter gets the arguments by
/// name, as bind_arguments() binds them; one without ignores what is given.
class Handler {
 public:
  Handler() = default;
  template <typename C>
  Handler(void (C::*function)(const Call&))
      : run_([function](TableComponent& component, const Call& call, const Dict&) {
          (static_cast<C&>(component).*function)(call);
        }) {}
  template <typename C>
  Handler(void (C::*function)(const Call&, const Dict&))
      : run_([function](TableComponent& component, const Call& call, const Dict& arguments) {
          (static_cast<C&>(component).*function)(call, arguments);
        }),
        takes_arguments_(true) {}

  bool takes_arguments() const { return takes_arguments_; }
  void operator()(TableComponent& component, const Call& call, const Dict& arguments) const {
    run_(component, call, arguments);
  }

 private:
  std::function<void(TableComponent&, const Call&, const Dict&)> run_;
  bool takes_arguments_ = false;
};

/// When a call takes its transition: before its arguments are read, or where its handler says accept(), because what
/// the handler finds may change the state first.
enum class Acceptance : bool { before_handler, by_handler };

struct ParameterRow {
  std::string name;
  Value type = {};
  std::string unit = {};
  std::optional<double> min = {}, max = {};
  std::optional<Value> value = {};  // default
  std::string doc = {};
};

struct OperationRow {
  std::string name;
  Handler handler;
  std::vector<ParameterRow> parameters = {};
  Value result = {}, error = {};
  bool safe = false;
  bool moves = false;
  bool held = false;
  bool paces = false;
  bool reads = false;
  Acceptance acceptance = Acceptance::before_handler;
  std::string doc = {};
};

struct EventRow {
  std::string name;
  Value data = {};
  bool sampled = false;
  std::optional<double> rate_hz = {};
  std::string doc = {};
};

/// A transition of the RSM (Definition 4.3): state `src`, or every state, accepts `operation` and goes to `dst`.
/// Without an operation it is spontaneous.
struct TransitionRow {
  std::string id;
  std::optional<std::string> src = {};
  std::string dst = {};
  std::optional<std::string> operation = {};
  std::vector<std::string> events = {};
  std::vector<std::string> defer = {};
  std::optional<std::string> error = {};
  bool concurrent = false;   // each call is answered by itself (R25)
  std::string refused = {};  // the spontaneous transition that follows at once if the call is refused; empty: none
};

/// All that a component declares, in the order of its RSM.
struct Declaration {
  std::string name;
  std::vector<OperationRow> operations = {};
  std::vector<EventRow> events = {};
  std::vector<rsm::Uses> subscribes = {};
  std::vector<rsm::ServiceState> states = {};
  std::string init = {};
  std::vector<TransitionRow> transitions = {};
  Value meta = {};
};

class OperationTable {
 public:
  struct Operation {
    Handler handler;
    Acceptance acceptance = Acceptance::before_handler;
  };

  /// Requires a declaration that breaks no constraint of Definitions 4.1 to 4.3, has a handler for each operation, and
  /// whose `refused` are spontaneous transitions.
  explicit OperationTable(const Declaration& declaration);

  /// The RSM that the table stands for; frozen.
  const rsm::Service& model() const { return model_; }

  /// The operation of this name. Requires that there is one.
  const Operation& operation(std::string_view name) const;
  /// `refused` of the row `transition`.
  const std::string& refused(std::string_view transition) const;

 private:
  rsm::Service model_;
  std::map<std::string, Operation, std::less<>> operations_;
  std::map<std::string, std::string, std::less<>> refused_;  // by id of the transition
};

}  // namespace race::services
