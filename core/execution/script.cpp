#include "core/execution/script.h"

#include <utility>

#include "core/edit/apply.h"
#include "core/edit/tree.h"
#include "core/execution/scripted_services.h"
#include "core/execution/step_json.h"
#include "core/rcm/native.h"
#include "core/rcm/translate.h"

namespace race::execution {

using semantics::OutgoingCall;

namespace {

using Errors = std::vector<Error>;

tl::unexpected<Errors> failed(Errors errors, const std::string& path) {
  Errors out;
  append_below(out, std::move(errors), path);
  return tl::unexpected(std::move(out));
}

/// The document of a script, as its edits have made it.
class EditedDocument {
 public:
  EditedDocument(const rcm::Document& document, const Script& script)
      : document_(document), services_(script.services.begin(), script.services.end()) {}

  Checked<ExecutedModel> model() const {
    auto native = rcm::translate(document_);
    if (!native) return tl::unexpected(std::move(native).error());
    auto program = semantics::Program::build(*native, services_);
    if (!program) return tl::unexpected(std::move(program).error());
    return ExecutedModel{rcm::write_native(document_, *native).freeze(), std::move(*program), 0};
  }

  Checked<void> apply(const edit::Edit& edit) {
    auto applied = edit::apply(document_, edit);
    if (!applied) return tl::unexpected(Errors{std::move(applied).error()});
    document_ = std::move(applied->document);
    return {};
  }

 private:
  rcm::Document document_;
  Interfaces services_;
};

class ScriptRun {
 public:
  ScriptRun(EditedDocument document, const Script& script, Execution execution, OrderChoice order)
      : document_(std::move(document)),
        script_(script),
        execution_(std::move(execution)),
        services_(script, execution_),
        choice_(order) {
    execution_.set_order(make_order(execution_.run().program(), choice_));
  }
  ScriptRun(const ScriptRun&) = delete;

  Checked<Value> derive() {
    List steps;
    for (const ScriptStep& step : script_.steps) {
      if (execution_.is_over()) break;
      const std::string path = "steps/" + std::to_string(steps.size());
      post(step);
      if (auto taken = take_edit(step, path + "/edit"); !taken) return tl::unexpected(std::move(taken).error());
      List waits;
      auto progress = step.force ? force(*step.force, path + "/force") : execute(waits);
      if (!progress) return tl::unexpected(std::move(progress).error());
      for (const OutgoingCall& call : (*progress)->calls) services_.call(call);
      Dict json = derived_step(execution_, **progress).as_dict();
      if (!waits.empty()) json.set("waits", std::move(waits));
      steps.emplace_back(std::move(json));
      services_.step(step);
    }
    Dict document;
    document.set("steps", std::move(steps));
    set_status(execution_.run(), document);
    return Value(std::move(document));
  }

 private:
  static constexpr Recording kTrees{.entry = false, .derivation = true};

  // The inputs of a script step join those that wait.
  void post(const ScriptStep& step) {
    for (const ScriptEvent& event : step.events) execution_.post_event(event.service, event.event, event.data);
    for (const ScriptResponse& response : step.responses) {
      const std::uint64_t call = execution_.run().find_call(response.service, response.operation, response.call);
      if (call != 0) execution_.post_response(call, response.is_error, response.data);
    }
  }

  // Edits that wait are one: the model that they lead to.
  Checked<void> take_edit(const ScriptStep& step, const std::string& path) {
    if (!step.edit) return {};
    if (execution_.run().position() == 0) return failed({{ErrorCode::conflict, "the run has not begun", ""}}, path);
    if (auto applied = document_.apply(*step.edit); !applied) return failed(std::move(applied).error(), path);
    auto model = document_.model();
    if (!model) return failed(std::move(model).error(), path);
    waiting_edit_ = std::move(*model);
    return {};
  }

  Checked<const Progress*> force(const semantics::Force& force, const std::string& path) {
    auto progress = execution_.force(force, kTrees);
    if (!progress) return failed({std::move(progress).error()}, path);
    return *progress;
  }

  // The edit if it can be carried over, else what is next. `waits`: what holds the edit up.
  Checked<const Progress*> execute(List& waits) {
    if (waiting_edit_) {
      auto progress = execution_.edit({}, *waiting_edit_, kTrees);
      if (progress) {
        waiting_edit_.reset();
        execution_.set_order(make_order(execution_.run().program(), choice_));
        return *progress;
      }
      waits = obstacles_json(progress.error());
    }
    return &execution_.step(kTrees);
  }

  EditedDocument document_;
  const Script& script_;
  Execution execution_;
  ScriptedServices services_;
  OrderChoice choice_;
  std::optional<ExecutedModel> waiting_edit_;
};

}  // namespace

Checked<Value> derive(const rcm::Document& document, const Script& script, OrderChoice order) {
  EditedDocument edited(document, script);
  const auto model = edited.model();
  if (!model) return tl::unexpected(model.error());
  auto execution = Execution::create(model->program, script.arguments);
  if (!execution) return tl::unexpected(Errors{std::move(execution).error()});
  return ScriptRun(std::move(edited), script, std::move(*execution), order).derive();
}

}  // namespace race::execution
