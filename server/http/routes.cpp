#include "server/http/routes.h"

#include <array>

#include "server/http/errors.h"

namespace race::server {
namespace {

constexpr std::array kRoutes = {
    Route{"GET", "/api/v1/health", get_health},
    Route{"GET", "/api/v1/rules", get_rules},
    Route{"GET", "/api/v1/documents", list_documents},
    Route{"GET", "/api/v1/documents/{name}", get_document},
    Route{"PUT", "/api/v1/documents/{name}", put_document},
    Route{"GET", "/api/v1/documents/{name}/native", get_document_native},
    Route{"GET", "/api/v1/services", list_services},
    Route{"GET", "/api/v1/cores", list_cores},
    Route{"POST", "/api/v1/cores", create_core},
    Route{"GET", "/api/v1/cores/{id}", get_core},
    Route{"DELETE", "/api/v1/cores/{id}", delete_core},
    Route{"POST", "/api/v1/cores/{id}/start", start_core},
    Route{"POST", "/api/v1/cores/{id}/pause", pause_core},
    Route{"POST", "/api/v1/cores/{id}/resume", resume_core},
    Route{"POST", "/api/v1/cores/{id}/stop", stop_core},
    Route{"POST", "/api/v1/cores/{id}/step", step_core},
    Route{"GET", "/api/v1/cores/{id}/native", get_core_native},
    Route{"GET", "/api/v1/cores/{id}/state", get_core_state},
    Route{"GET", "/api/v1/cores/{id}/derivations", get_derivations},
    Route{"GET", "/api/v1/cores/{id}/script", get_core_script},
    Route{"GET", "/api/v1/cores/{id}/journal", get_core_journal},
    Route{"GET", "/api/v1/cores/{id}/why", get_why},
    Route{"GET", "/api/v1/cell", get_cell},
    Route{"GET", "/api/v1/cell/person", get_person},
    Route{"POST", "/api/v1/cell/person", execute_person_command},
    Route{"GET", "/api/v1/cell/{file}", get_cell_file},
};

// Cuts the first part off a path "/a/b": "a", leaving "/b".
std::string_view first_part(std::string_view& path) {
  const auto end = path.find('/', 1);
  const std::string_view part = path.substr(1, end == std::string_view::npos ? end : end - 1);
  path = end == std::string_view::npos ? std::string_view() : path.substr(end);
  return part;
}

}  // namespace

std::span<const Route> routes() { return kRoutes; }

std::optional<std::map<std::string, std::string, std::less<>>> match(std::string_view pattern, std::string_view path) {
  std::map<std::string, std::string, std::less<>> parameters;
  while (!pattern.empty() && !path.empty()) {
    const std::string_view expected = first_part(pattern), part = first_part(path);
    if (expected.starts_with('{')) {
      if (part.empty()) return std::nullopt;
      parameters.emplace(expected.substr(1, expected.size() - 2), part);
    } else if (expected != part) {
      return std::nullopt;
    }
  }
  if (!pattern.empty() || !path.empty()) return std::nullopt;
  return parameters;
}

Reply handle(Request request, Application& app) {
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
      auto reply = route.handler(request, app);
      return reply ? std::move(*reply) : refusal(reply.error());
    } catch (const std::exception& failure) {
      app.log("server", request.method + " " + request.path + ": " + failure.what());
      return refusal(500, "internal", "the server failed to answer; see its log");
    }
  }
  if (allowed.empty()) return refusal(404, "not_found", "there is no such route");
  Reply reply = refusal(405, "method", "this route has " + allowed);
  reply.headers.emplace_back("Allow", allowed);
  return reply;
}

Backend make_backend(Application& app) {
  return {[&app](Request request) { return handle(std::move(request), app); }, app.hub(), app.displays(),
          app.cell().remotes(), [&app](const std::string& text) { app.log("server", text); }};
}

}  // namespace race::server
