// TableComponent: a Component that accepts calls by its OperationTable. It holds the RSM state, follows each transition
// that it announces, and rejects a call that the state accepts in none (R7): the only place where that is decided.
//
// Threads: as a Component.
#pragma once

#include <string>
#include <string_view>

#include "core/value/expected.h"
#include "services/component.h"
#include "services/operation_table.h"

namespace race::services {

class TableComponent : public Component {
 public:
  const rsm::Service& model() const final { return table_.model(); }
  /// Rejects the call, or takes its transition, reads its arguments and calls the handler. A wrong argument is answered
  /// by refuse_arguments() after the transition was taken.
  void call(const Call& call) override;

 protected:
  /// In the initial state. Both outlive the component.
  TableComponent(const OperationTable& table, ServiceHost& host);

  ServiceHost& host() const { return host_; }
  /// Takes the spontaneous transition `id`, which answers `call` if several may be answered. Requires that the present
  /// state has it.
  void take(std::string_view id, CallId call = 0);
  /// Takes the transition by which the present state accepts `call`. Only for handlers with Acceptance::by_handler;
  /// requires that there is one.
  void accept(const Call& call);
  /// Answers the present call with an error: accepts it if its handler has not yet, and takes the transition `refused`
  /// of the row by which it was accepted.
  void refuse(const Call& call, Value error);
  /// An argument does not fit: refuses the present call with `code`, `message` and, if the error has a path,
  /// `argument`. A component whose errors differ overrides it.
  virtual void refuse_arguments(const Call& call, const Error& error);

 private:
  const OperationTable& table_;
  ServiceHost& host_;
  std::string state_;                             // of the RSM
  const rsm::Transition* accepted_by_ = nullptr;  // by which the present call was accepted; nullptr: not yet
};

}  // namespace race::services
