// GET /api/v1/cores/{id}/why?port=&state=&action=&parameter=&step=&micro= and /api/v1/runs/{run}/why: why a port does
// not fire or an action is not executed now, or why it did in a past micro step; what a parameter is resolved to.
#include <limits>
#include <optional>

#include "server/execution/cores.h"
#include "server/handlers/handlers.h"
#include "server/handlers/query.h"
#include "server/handlers/runs.h"
#include "server/runs/run_replay.h"

namespace race::server {

namespace {

constexpr int kMost = std::numeric_limits<int>::max();

struct MicroStep {
  std::uint64_t step;
  int micro;
};
struct Question {
  execution::WhyQuestion subject;
  std::optional<MicroStep> before;  // none: as things are
};

/// `port`, or `state` with `action` or `parameter`.
Expected<execution::WhyQuestion> subject_of(const Request& request) {
  execution::WhyQuestion subject{
      query_text(request, "port"), query_text(request, "state"), {}, query_text(request, "parameter")};
  ASSIGN_OR_RETURN(const auto action, query_number(request, "action", {0, kMost}));
  if (action) subject.action = static_cast<std::uint32_t>(*action);
  if (subject.port.empty() && subject.state.empty())
    return unexpected(ErrorCode::missing,
                      "which port? ?port=Root/A.success; or ?state=Root/A and an action or parameter", "port");
  const int asked = !subject.port.empty() + subject.action.has_value() + !subject.parameter.empty();
  if (asked == 0) return unexpected(ErrorCode::missing, "which action or parameter of the state?", "action");
  if (asked > 1 || (!subject.port.empty() && !subject.state.empty()))
    return unexpected(ErrorCode::conflict, "a port, an action of a state, or a parameter of a state: one of them",
                      subject.port.empty() ? "parameter" : "port");
  return subject;
}

Expected<Question> question_of(const Request& request) {
  Question question;
  ASSIGN_OR_RETURN(question.subject, subject_of(request));
  ASSIGN_OR_RETURN(const auto step, query_number(request, "step", {1, kMost}));
  ASSIGN_OR_RETURN(const auto micro, query_number(request, "micro", {0, kMost}));
  if (step.has_value() != micro.has_value())
    return unexpected(ErrorCode::missing, "`step` and `micro` go together", step ? "micro" : "step");
  if (step) question.before = MicroStep{static_cast<std::uint64_t>(*step), static_cast<int>(*micro)};
  return question;
}

}  // namespace

void get_why(const Request& request, Respond respond, Cores& cores) {
  const auto core = core_of(request, cores);
  if (!core) return respond(tl::unexpected(core.error()));
  auto question = question_of(request);
  if (!question) return respond(failed(question.error()));
  auto& [subject, before] = *question;
  if (!before) return (*core)->why(std::move(subject), answer_to(std::move(respond)));
  (*core)->why_before(std::move(subject), before->step, before->micro, request.gone, answer_to(std::move(respond)));
}

void get_run_why(const Request& request, Respond respond, Runs& runs, Worker& replays) {
  const auto question = question_of(request);
  if (!question) return respond(failed(question.error()));
  answer_replay(request, std::move(respond), replays,
                [&runs, run = run_number(request.parameters.at("run")), question = *question](const Stop& stop) {
                  const MicroStep before = question.before.value_or(MicroStep{0, kMost});
                  return run_why(runs, run, question.subject, before.step, before.micro, &stop);
                });
}

}  // namespace race::server
