#include "server/handlers/routes.h"

#include <array>

#include "server/cell/cell.h"
#include "server/http/refusal.h"
#include "server/log/event_log.h"
#include "server/wire/path_pattern.h"

namespace race::server {
namespace {

template <auto handler>
struct Caller;

// Takes the resources that are the handler's parameters, by their types.
template <typename... Needed, Handled (*handler)(const Request&, Needed&...)>
struct Caller<handler> {
  static Handled call(const Request& request, const Resources& resources) {
    return handler(request, std::get<Needed&>(resources)...);
  }
};

template <auto handler>
constexpr auto call = &Caller<handler>::call;

constexpr std::array kRoutes = {
    Route{"GET", "/api/v1/health", call<get_health>},
    Route{"GET", "/api/v1/rules", call<get_rules>},
    Route{"GET", "/api/v1/documents", call<list_documents>},
    Route{"GET", "/api/v1/documents/{name}", call<get_document>},
    Route{"PUT", "/api/v1/documents/{name}", call<put_document>},
    Route{"POST", "/api/v1/documents/{name}/edits", call<edit_document>},
    Route{"GET", "/api/v1/documents/{name}/revisions", call<get_revisions>},
    Route{"GET", "/api/v1/documents/{name}/revisions/{revision}", call<get_revision>},
    Route{"POST", "/api/v1/documents/{name}/restore", call<restore_document>},
    Route{"POST", "/api/v1/documents/{name}/branch", call<branch_document>},
    Route{"GET", "/api/v1/documents/{name}/native", call<get_document_native>},
    Route{"GET", "/api/v1/backups", call<list_backups>},
    Route{"POST", "/api/v1/backups", call<create_backup>},
    Route{"DELETE", "/api/v1/backups/{name}", call<delete_backup>},
    Route{"POST", "/api/v1/backups/{name}/restore", call<restore_backup>},
    Route{"GET", "/api/v1/services", call<list_services>},
    Route{"GET", "/api/v1/cores", call<list_cores>},
    Route{"POST", "/api/v1/cores", call<create_core>},
    Route{"GET", "/api/v1/cores/{id}", call<get_core>},
    Route{"DELETE", "/api/v1/cores/{id}", call<delete_core>},
    Route{"POST", "/api/v1/cores/{id}/load", call<load_core>},
    Route{"POST", "/api/v1/cores/{id}/start", call<start_core>},
    Route{"POST", "/api/v1/cores/{id}/pause", call<pause_core>},
    Route{"POST", "/api/v1/cores/{id}/resume", call<resume_core>},
    Route{"POST", "/api/v1/cores/{id}/stop", call<stop_core>},
    Route{"POST", "/api/v1/cores/{id}/step", call<step_core>},
    Route{"PUT", "/api/v1/cores/{id}/breakpoints", call<set_breakpoints>},
    Route{"PUT", "/api/v1/cores/{id}/live", call<set_core_live>},
    Route{"POST", "/api/v1/cores/{id}/force", call<force_core>},
    Route{"GET", "/api/v1/cores/{id}/native", call<get_core_native>},
    Route{"GET", "/api/v1/cores/{id}/state", call<get_core_state>},
    Route{"GET", "/api/v1/cores/{id}/derivations", call<get_derivations>},
    Route{"GET", "/api/v1/cores/{id}/script", call<get_core_script>},
    Route{"GET", "/api/v1/cores/{id}/journal", call<get_core_journal>},
    Route{"GET", "/api/v1/cores/{id}/why", call<get_why>},
    Route{"GET", "/api/v1/runs", call<list_runs>},
    Route{"POST", "/api/v1/runs", call<import_run>},
    Route{"GET", "/api/v1/runs/{run}", call<get_run>},
    Route{"DELETE", "/api/v1/runs/{run}", call<delete_run>},
    Route{"GET", "/api/v1/runs/{run}/native", call<get_run_native>},
    Route{"GET", "/api/v1/runs/{run}/derivations", call<get_run_derivations>},
    Route{"GET", "/api/v1/runs/{run}/journal", call<get_run_journal>},
    Route{"GET", "/api/v1/runs/{run}/script", call<get_run_script>},
    Route{"GET", "/api/v1/runs/{run}/samples", call<get_run_samples>},
    Route{"GET", "/api/v1/runs/{run}/export", call<get_run_export>},
    Route{"GET", "/api/v1/runs/{run}/compare", call<compare_run>},
    Route{"GET", "/api/v1/boot", call<get_boot>},
    Route{"PUT", "/api/v1/boot", call<put_boot>},
    Route{"GET", "/api/v1/cell", call<get_cell>},
    Route{"GET", "/api/v1/cell/person", call<get_person>},
    Route{"POST", "/api/v1/cell/person", call<execute_person_command>},
    Route{"GET", "/api/v1/cell/{file}", call<get_cell_file>},
};

}  // namespace

std::span<const Route> routes() { return kRoutes; }

Reply handle(Request request, const Resources& resources) {
  std::string allowed;
  for (const Route& route : kRoutes) {
    auto parameters = match(route.pattern, request.path);
    if (!parameters) continue;
    if (route.method != request.method) {
      allowed += (allowed.empty() ? "" : ", ") + std::string(route.method);
      continue;
    }
    request.parameters = std::move(*parameters);
    try {
      auto reply = route.handle(request, resources);
      return reply ? std::move(*reply) : refusal(reply.error());
    } catch (const std::exception& failure) {
      const services::Time now = std::get<Cell&>(resources).clock().now();
      std::get<EventLog&>(resources).append(now, "server", request.method + " " + request.path + ": " + failure.what(),
                                            LogLevel::error);
      return refusal(500, "internal", "the server failed to answer; see its log");
    }
  }
  if (allowed.empty()) return refusal(404, "not_found", "there is no such route");
  Reply reply = refusal(405, "method", "this route has " + allowed);
  reply.headers.emplace_back("Allow", allowed);
  return reply;
}

}  // namespace race::server
