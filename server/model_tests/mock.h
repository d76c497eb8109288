// Mock: a component that is nothing but its RSM. It accepts a call as the rules say (Trans1), answers what the script
// of a test lists, and where that lists nothing, what a seed chooses among all answers that the RSM allows. The host
// holds what it announces against the same RSM, as of any component.
//
// Threads: as a Component.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/rsm/rules.h"
#include "server/model_tests/allowed_answers.h"
#include "server/model_tests/any_value.h"
#include "server/model_tests/test_file.h"
#include "services/component.h"

namespace race::server {

/// Codes of errors that the cell gives, not the service (R7): the service does not take such a call.
bool is_error_of_cell(std::string_view code);

class Mock final : public services::Component {
 public:
  /// `problems` gets what the script lists and the RSM does not allow then. All but the model and the script outlive
  /// it. Requires a model with states, and a script that fits it (check_mock()).
  Mock(rsm::Service model, MockScript script, std::uint64_t seed, std::vector<std::string>& problems,
       services::ServiceHost& host);

  const rsm::Service& model() const override { return model_; }
  void call(const services::Call& call) override;
  void step() override;

 private:
  /// A call that has no response yet.
  struct OpenCall {
    std::string operation;
    std::optional<MockAnswer> listed;
    services::Time due = 0;
    std::vector<std::string> defer = {};       // of the transition that took it
    std::optional<rsm::Answer> resolved = {};  // by its own transition; else a spontaneous one answers it
    bool by_cell = false;
    bool was_refused = false;  // the RSM did not allow the listed answer: said once
  };

  std::optional<MockAnswer> next_answer(const std::string& operation);
  void answer_due(services::CallId call);
  void pass_on(const OpenCall& open);
  void take(const AllowedAnswer& way, services::CallId call);
  void put(const rsm::Effect& effect, services::CallId kept = 0);
  void respond(const rsm::Answer& answer);
  void put_listed(const MockEvent& event);
  void put_samples(services::Time now);
  Value event_data(const std::string& event);
  const rsm::Operation& operation(std::string_view name) const;

  const rsm::Service model_;
  const MockScript script_;
  Random random_;
  std::vector<std::string>& problems_;
  services::ServiceHost& host_;
  rsm::Instance instance_;
  std::set<std::size_t> used_;  // answers of the script
  std::map<services::CallId, OpenCall> open_;
  std::size_t next_event_ = 0;  // of the script
  std::set<std::size_t> put_;   // those from there on that a transition has put before their time
  std::map<std::string, services::Time> next_sample_;
};

}  // namespace race::server
