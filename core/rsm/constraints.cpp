// The constraints of Definitions 4.1 to 4.3: names, unique declarations, and references to what is declared. An empty
// name is one that could not be read; that it is missing has been reported.
#include <set>

#include "core/rsm/document.h"
#include "core/value/error_list.h"
#include "core/value/fields.h"

namespace race::rsm {
namespace {

class Constraints {
 public:
  Constraints(const Service& service, const std::string& path) : service_(service), path_(path) {}

  std::vector<Error> check() {
    if (!service_.name.empty() && !is_name(service_.name)) add(ErrorCode::name, quote(service_.name) + " is no name");
    declare_interface();
    declare_automaton();
    for (const ServiceState& state : service_.states) refer("event", state.events, events_, "state", state.name);
    for (const Transition& transition : service_.transitions) check_references(transition);
    check_init();
    return std::move(errors_);
  }

 private:
  using Names = std::set<std::string, std::less<>>;
  static constexpr std::string_view kTransition = "transition";  // the id of one is any text

  void add(ErrorCode code, std::string message) { add_error(errors_, {code, std::move(message), path_}); }

  void declare(std::string_view what, const std::string& name, Names& names) {
    if (name.empty()) return;
    if (what != kTransition && !is_name(name))
      add(ErrorCode::name, std::string(what) + ": " + quote(name) + " is no name");
    if (!names.insert(name).second)
      add(ErrorCode::duplicate, std::string(what) + " " + quote(name) + " is declared twice");
  }

  void declare_interface() {
    for (const Operation& operation : service_.operations) {
      declare("operation", operation.name, operations_);
      Names parameters;
      for (const OperationParameter& parameter : operation.parameters)
        declare("operation " + quote(operation.name) + ", parameter", parameter.name, parameters);
    }
    for (const Event& event : service_.events) {
      declare("event", event.name, events_);
      if (operations_.contains(event.name))
        add(ErrorCode::duplicate, quote(event.name) + " is both an operation and an event");
    }
  }

  void declare_automaton() {
    for (const ServiceState& state : service_.states) declare("state", state.name, states_);
    for (const Transition& transition : service_.transitions) declare(kTransition, transition.id, transitions_);
  }

  void refer(std::string_view what, const std::string& name, const Names& names, std::string_view holder,
             std::string_view holder_name) {
    if (name.empty() || names.contains(name)) return;
    add(ErrorCode::reference,
        std::string(holder) + " " + quote(holder_name) + ": there is no " + std::string(what) + " " + quote(name));
  }

  void refer(std::string_view what, const std::vector<std::string>& list, const Names& names, std::string_view holder,
             std::string_view holder_name) {
    for (const std::string& name : list) refer(what, name, names, holder, holder_name);
  }

  void check_references(const Transition& transition) {
    if (transition.src) refer("state", *transition.src, states_, "transition", transition.id);
    refer("state", transition.dst, states_, "transition", transition.id);
    if (transition.operation) refer("operation", *transition.operation, operations_, "transition", transition.id);
    refer("event", transition.events, events_, "transition", transition.id);
    refer("transition", transition.defer, transitions_, "transition", transition.id);
    if (transition.concurrent && (!transition.operation || transition.defer.empty()))
      add(ErrorCode::reference,
          "transition " + quote(transition.id) + ": `concurrent` needs an operation, and a transition that answers it");
  }

  void check_init() {
    if (!service_.init.empty()) return refer("state", service_.init, states_, "init", service_.init);
    if (!service_.states.empty()) add(ErrorCode::missing, "a service with states needs the field `init`");
  }

  const Service& service_;
  const std::string& path_;
  std::vector<Error> errors_;
  Names operations_, events_, states_, transitions_;
};

}  // namespace

std::vector<Error> violations(const Service& service, const std::string& path) {
  return Constraints(service, path).check();
}

}  // namespace race::rsm
