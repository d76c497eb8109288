// GET /api/v1/cores/{id}/why?port=&step=&micro= and /api/v1/runs/{run}/why: why a port does not fire now, or why it
// fired in a past micro step.
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
struct WhyQuestion {
  std::string port;
  std::optional<MicroStep> before;  // none: as things are
};

Expected<WhyQuestion> question_of(const Request& request) {
  WhyQuestion question{query_text(request, "port"), {}};
  if (question.port.empty()) return unexpected(ErrorCode::missing, "which port? ?port=Root/A.success", "port");
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
  const auto question = question_of(request);
  if (!question) return respond(failed(question.error()));
  const auto& [port, before] = *question;
  if (!before) return (*core)->why(port, answer_to(std::move(respond)));
  (*core)->why_before(port, before->step, before->micro, request.gone, answer_to(std::move(respond)));
}

void get_run_why(const Request& request, Respond respond, Runs& runs, Worker& replays) {
  const auto question = question_of(request);
  if (!question) return respond(failed(question.error()));
  answer_replay(request, std::move(respond), replays,
                [&runs, run = run_number(request.parameters.at("run")), question = *question](const Stop& stop) {
                  const MicroStep before = question.before.value_or(MicroStep{0, kMost});
                  return run_why(runs, run, question.port, before.step, before.micro, &stop);
                });
}

}  // namespace race::server
