#include "server/handlers/routes.h"

#include <array>

#include "core/value/json.h"
#include "server/accounts/audit_log.h"
#include "server/cell/cell.h"
#include "server/handlers/idempotency.h"
#include "server/handlers/tasks.h"
#include "server/http/refusal.h"
#include "server/log/event_log.h"
#include "server/wire/calendar.h"
#include "server/wire/path_pattern.h"

namespace race::server {
namespace {

template <auto handler>
struct Caller;

// Takes the resources that are the handler's parameters, by their types.
template <typename... Needed, Handled (*handler)(const Request&, Needed&...)>
struct Caller<handler> {
  static void call(const Request& request, Respond respond, const Resources& resources) {
    respond(handler(request, std::get<Needed&>(resources)...));
  }
};
// One that responds later.
template <typename... Needed, void (*handler)(const Request&, Respond, Needed&...)>
struct Caller<handler> {
  static void call(const Request& request, Respond respond, const Resources& resources) {
    handler(request, std::move(respond), std::get<Needed&>(resources)...);
  }
};

template <auto handler>
constexpr auto call = &Caller<handler>::call;

constexpr bool kBody = true, kNoBody = false, kCreates = true, kMakesNothing = false;
constexpr auto kLong = Route::Long::yes, kStoppable = Route::Long::stoppable;

constexpr std::array kRoutes = {
    Route{"GET", "/api/v1/health", call<get_health>},
    Route{"GET", "/metrics", call<get_metrics>},
    Route{"GET", "/api/v1/me", call<get_me>},
    Route{"PUT", "/api/v1/me/password", call<change_password>, kBody},
    Route{"POST", "/api/v1/login", call<log_in>, kBody},
    Route{"POST", "/api/v1/logout", call<log_out>},
    Route{"POST", "/api/v1/tickets", call<create_ticket>},
    Route{"POST", "/api/v1/pairings", call<create_pairing>, kBody},
    Route{"POST", "/api/v1/pair", call<pair_display>, kBody},
    Route{"GET", "/api/v1/addresses", call<get_addresses>},
    Route{"GET", "/api/v1/accounts", call<list_accounts>},
    Route{"POST", "/api/v1/accounts", call<create_account>, kBody},
    Route{"PUT", "/api/v1/accounts/{name}", call<change_account>, kBody},
    Route{"DELETE", "/api/v1/accounts/{name}", call<remove_account>},
    Route{"GET", "/api/v1/accounts/{name}/tokens", call<list_account_tokens>},
    Route{"POST", "/api/v1/accounts/{name}/tokens", call<create_account_token>, kBody},
    Route{"DELETE", "/api/v1/accounts/{name}/tokens/{digest}", call<revoke_account_token>},
    Route{"GET", "/api/v1/authority", call<get_authority>},
    Route{"POST", "/api/v1/stop", call<stop_cell>},
    Route{"POST", "/api/v1/stop/reset", call<reset_stop>},
    Route{"GET", "/api/v1/control", call<get_control>},
    Route{"POST", "/api/v1/control/answer", call<answer_control_request>, kBody},
    Route{"PUT", "/api/v1/control/mode", call<set_mode>, kBody},
    Route{"GET", "/api/v1/audit", call<get_audit>, kNoBody, "before limit"},
    Route{"GET", "/api/v1/rules", call<get_rules>},
    Route{"GET", "/api/v1/documents", call<list_documents>, kNoBody, "after limit"},
    Route{"GET", "/api/v1/documents/{name}", call<get_document>},
    Route{"PUT", "/api/v1/documents/{name}", call<put_document>, kBody, "draft author message revision"},
    Route{"DELETE", "/api/v1/documents/{name}", call<delete_document>},
    Route{"POST", "/api/v1/documents/{name}/edits", call<edit_document>, kBody},
    Route{"GET", "/api/v1/documents/{name}/revisions", call<get_revisions>, kNoBody, "before limit"},
    Route{"GET", "/api/v1/documents/{name}/revisions/{revision}", call<get_revision>},
    Route{"POST", "/api/v1/documents/{name}/restore", call<restore_document>, kBody},
    Route{"POST", "/api/v1/documents/{name}/branch", call<branch_document>, kBody, "", kCreates},
    Route{"GET", "/api/v1/documents/{name}/native", call<get_document_native>},
    Route{"GET", "/api/v1/documents/{name}/breakpoints", call<get_document_breakpoints>, kNoBody, "author"},
    Route{"PUT", "/api/v1/documents/{name}/breakpoints", call<put_document_breakpoints>, kBody, "author"},
    Route{"GET", "/api/v1/documents/{name}/bundle", call<get_document_bundle>},
    Route{"POST", "/api/v1/bundles", call<install_bundle>, kBody, "as author message", kCreates},
    Route{"POST", "/api/v1/documents/{name}/proposals", call<propose_document>, kBody, "author", kCreates},
    Route{"GET", "/api/v1/proposals", call<list_proposals>, kNoBody, "document status after limit"},
    Route{"GET", "/api/v1/proposals/{id}", call<get_proposal>},
    Route{"POST", "/api/v1/proposals/{id}/accept", call<accept_proposal>, kNoBody, "author"},
    Route{"POST", "/api/v1/proposals/{id}/decline", call<decline_proposal>, kBody, "author"},
    Route{"DELETE", "/api/v1/proposals/{id}", call<withdraw_proposal>, kNoBody, "author"},
    Route{"GET", "/api/v1/backups", call<list_backups>},
    Route{"POST", "/api/v1/backups", call<create_backup>, kNoBody, "", kCreates, kLong},
    Route{"GET", "/api/v1/backups/{name}", call<get_backup>},
    Route{"DELETE", "/api/v1/backups/{name}", call<delete_backup>},
    Route{"POST", "/api/v1/backups/{name}/restore", call<restore_backup>, kNoBody, "", kMakesNothing, kLong},
    Route{"GET", "/api/v1/services", call<list_services>},
    Route{"POST", "/api/v1/services/{service}/calls", call<call_service>, kBody},
    Route{"GET", "/api/v1/cores", call<list_cores>},
    Route{"POST", "/api/v1/cores", call<create_core>, kBody, "", kCreates},
    Route{"GET", "/api/v1/cores/{id}", call<get_core>},
    Route{"DELETE", "/api/v1/cores/{id}", call<delete_core>},
    Route{"POST", "/api/v1/cores/{id}/load", call<load_core>, kBody},
    Route{"POST", "/api/v1/cores/{id}/start", call<start_core>, kBody},
    Route{"POST", "/api/v1/cores/{id}/pause", call<pause_core>},
    Route{"POST", "/api/v1/cores/{id}/resume", call<resume_core>, kBody},
    Route{"POST", "/api/v1/cores/{id}/stop", call<stop_core>},
    Route{"POST", "/api/v1/cores/{id}/step", call<step_core>, kBody},
    Route{"POST", "/api/v1/cores/{id}/confirm_edit", call<confirm_core_edit>, kBody},
    Route{"PUT", "/api/v1/cores/{id}/breakpoints", call<set_breakpoints>, kBody, "author"},
    Route{"PUT", "/api/v1/cores/{id}/live", call<set_core_live>, kBody},
    Route{"POST", "/api/v1/cores/{id}/force", call<force_core>, kBody},
    Route{"GET", "/api/v1/cores/{id}/native", call<get_core_native>},
    Route{"GET", "/api/v1/cores/{id}/state", call<get_core_state>},
    Route{"GET", "/api/v1/cores/{id}/events", call<get_core_events>},
    Route{"GET", "/api/v1/cores/{id}/derivations", call<get_derivations>, kNoBody, "from to"},
    Route{"GET", "/api/v1/cores/{id}/script", call<get_core_script>},
    Route{"GET", "/api/v1/cores/{id}/journal", call<get_core_journal>},
    Route{"GET", "/api/v1/cores/{id}/why", call<get_why>, kNoBody, "port state action parameter step micro"},
    Route{"GET", "/api/v1/cores/{id}/past", call<get_past>, kNoBody, "step micro"},
    Route{"GET", "/api/v1/queue", call<list_queue>, kNoBody, "after limit"},
    Route{"POST", "/api/v1/queue", call<create_queued_run>, kBody, "", kCreates},
    Route{"POST", "/api/v1/queue/resume", call<resume_queue>},
    Route{"GET", "/api/v1/queue/{id}", call<get_queued_run>},
    Route{"DELETE", "/api/v1/queue/{id}", call<cancel_queued_run>},
    Route{"GET", "/api/v1/runs", call<list_runs>, kNoBody, "document before limit"},
    Route{"POST", "/api/v1/runs", call<import_run>, kBody, "", kCreates, kStoppable},
    Route{"GET", "/api/v1/runs/{run}", call<get_run>},
    Route{"DELETE", "/api/v1/runs/{run}", call<delete_run>},
    Route{"GET", "/api/v1/runs/{run}/native", call<get_run_native>},
    Route{"GET", "/api/v1/runs/{run}/derivations", call<get_run_derivations>, kNoBody, "from to"},
    Route{"GET", "/api/v1/runs/{run}/past", call<get_run_past>, kNoBody, "step micro"},
    Route{"GET", "/api/v1/runs/{run}/why", call<get_run_why>, kNoBody, "port state action parameter step micro"},
    Route{"GET", "/api/v1/runs/{run}/journal", call<get_run_journal>},
    Route{"GET", "/api/v1/runs/{run}/script", call<get_run_script>},
    Route{"GET", "/api/v1/runs/{run}/samples", call<get_run_samples>},
    Route{"GET", "/api/v1/runs/{run}/pictures", call<get_run_pictures>},
    Route{"GET", "/api/v1/runs/{run}/pictures/{number}", call<get_run_picture>},
    Route{"GET", "/api/v1/runs/{run}/timing", call<get_run_timing>, kNoBody, "from to"},
    Route{"GET", "/api/v1/runs/{run}/export", call<get_run_export>},
    Route{"GET", "/api/v1/runs/{run}/test", call<get_run_test>},
    Route{"GET", "/api/v1/runs/{run}/compare", call<compare_run>, kNoBody, "with from"},
    Route{"GET", "/api/v1/tasks/{id}", call<get_task>},
    Route{"DELETE", "/api/v1/tasks/{id}", call<cancel_task>},
    Route{"GET", "/api/v1/boot", call<get_boot>},
    Route{"PUT", "/api/v1/boot", call<put_boot>, kBody},
    Route{"GET", "/api/v1/cell", call<get_cell>},
    Route{"GET", "/api/v1/cell/person", call<get_person>},
    Route{"POST", "/api/v1/cell/person", call<execute_person_command>, kBody},
    Route{"POST", "/api/v1/cell/reset", call<reset_cell>, kBody},
    Route{"GET", "/api/v1/cell/{file}", call<get_cell_file>},
};

// Served by the sockets themselves.
constexpr std::array<std::string_view, 3> kSockets = {"/api/v1/stream", "/api/v1/control/hold", "/api/v1/components"};

bool has_parameter(const Route& route, std::string_view name) {
  const std::string wanted = " " + std::string(name) + " ";
  return (" " + std::string(route.query) + " ").find(wanted) != std::string::npos;
}

std::vector<Error> unknown_parameters(const Route& route, const Request& request) {
  std::vector<Error> errors;
  for (const auto& [name, value] : request.query)
    if (!has_parameter(route, name))
      errors.push_back({ErrorCode::unknown_field, "this route has no such parameter", name});
  return errors;
}

Checked<void> check_empty(const std::string& text) {
  if (text.empty()) return {};
  const auto body = parse_json(text);
  if (!body) return failed(body.error());
  std::vector<Error> errors;
  Fields(*body, "", "the request", errors, Fields::Paths::field).close();
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return {};
}

// What is stored and cannot be read; a damaged text is found when somebody asks for it.
void log_damage(const std::string& path, const std::vector<Error>& errors, const Resources& resources) {
  if (errors.front().code != ErrorCode::corrupt) return;
  std::get<EventLog&>(resources).append(std::get<Cell&>(resources).clock().now(), "server",
                                        "GET " + path + ": " + to_string(errors.front()), LogLevel::error);
}

// Replies with what the handler responds.
void call_handler(const Route& route, const Request& request, const Resources& resources, TakeReply reply) {
  const bool is_get = request.method == "GET";
  route.handle(
      request,
      [reply = std::move(reply), resources, path = is_get ? request.path : ""](Handled handled) {
        if (handled) return reply(std::move(*handled));
        if (!path.empty()) log_damage(path, handled.error(), resources);
        reply(refusal(handled.error()));
      },
      resources);
}

// Whoever prefers that is answered before the work is done.
bool answers_before(const Route& route, const Request& request) {
  return route.is_long != Route::Long::no && Tasks::is_preferred(request);
}

// Replies that it will be done, and does it. What drops the work ends the task: its Answer is replied 503.
void begin_task(const Route& route, const Request& request, const Resources& resources, const TakeReply& reply) {
  auto begun = std::get<Tasks&>(resources).begin(request, route.is_long == kStoppable);
  if (!begun) return reply(refusal(std::vector<Error>{std::move(begun).error()}));
  const std::string id = begun->find("id")->as_string();
  const Answer done([resources, id, who = request.identity](const Reply& made) {
    std::get<AuditLog&>(resources).append(  // first: who hears of the end finds it there
        {0, now_ms(), who.account, who.address, "task " + id, std::to_string(made.status)});
    std::get<Tasks&>(resources).end(id, made);
  });
  Reply accepted = ok(std::move(*begun));
  accepted.status = 202;
  accepted.headers = {{"Location", "/api/v1/tasks/" + id}, {"Preference-Applied", "respond-async"}};
  reply(std::move(accepted));
  call_handler(route, request, resources, done);
}

void call_route(const Route& route, const Request& request, const Resources& resources, const Answer& answer) {
  if (const auto unknown = unknown_parameters(route, request); !unknown.empty()) return answer(refusal(400, unknown));
  if (!route.has_body)
    if (const auto empty = check_empty(request.body); !empty) return answer(refusal(empty.error()));
  const auto make = [&](TakeReply reply) {
    if (answers_before(route, request)) return begin_task(route, request, resources, reply);
    call_handler(route, request, resources, std::move(reply));
  };
  if (!route.creates) return make(answer);
  std::get<IdempotentAnswers&>(resources).answer(request, make, answer);
}

}  // namespace

std::span<const Route> routes() { return kRoutes; }
std::span<const std::string_view> websocket_paths() { return kSockets; }

std::string_view pattern_of(std::string_view method, std::string_view path) {
  for (const std::string_view socket : kSockets)
    if (method == "GET" && path == socket) return socket;
  for (const Route& route : kRoutes)
    if (route.method == method && match(route.pattern, path)) return route.pattern;
  return {};
}

void handle(Request request, const Resources& resources, const Answer& answer) {
  std::string allowed;
  for (const Route& route : kRoutes) {
    auto parameters = match(route.pattern, request.path);
    if (!parameters) continue;
    if (route.method != request.method) {
      allowed += (allowed.empty() ? "" : ", ") + std::string(route.method);
      continue;
    }
    request.parameters = std::move(*parameters);
    if (answers_before(route, request)) {
      request.gone = std::make_shared<Stop>(false);  // its client may go
      request.progress = std::make_shared<WorkProgress>();
    }
    return call_route(route, request, resources, answer);
  }
  if (allowed.empty()) return answer(refusal(404, "not_found", "there is no such route"));
  Reply reply = refusal(405, "method", "this route has " + allowed);
  reply.headers.emplace_back("Allow", allowed);
  answer(std::move(reply));
}

}  // namespace race::server
