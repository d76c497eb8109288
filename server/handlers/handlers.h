// One handler for each route of api/openapi.yaml, in a file of its name: takes a parsed request, returns a value.
// Sockets, limits and rights wrap them in one place.
//
// Threads: any thread of the handlers' pool; a handler may wait for a core.
#pragma once

#include "core/value/expected.h"
#include "server/application.h"
#include "server/http/message.h"

namespace race::server {

using Handled = Checked<Reply>;

Handled get_health(const Request& request, Application& app);
Handled get_rules(const Request& request, Application& app);
Handled list_documents(const Request& request, Application& app);
Handled get_document(const Request& request, Application& app);
Handled put_document(const Request& request, Application& app);
Handled get_document_native(const Request& request, Application& app);
Handled list_services(const Request& request, Application& app);
Handled list_cores(const Request& request, Application& app);
Handled create_core(const Request& request, Application& app);
Handled get_core(const Request& request, Application& app);
Handled delete_core(const Request& request, Application& app);
Handled start_core(const Request& request, Application& app);
Handled pause_core(const Request& request, Application& app);
Handled resume_core(const Request& request, Application& app);
Handled stop_core(const Request& request, Application& app);
Handled step_core(const Request& request, Application& app);
Handled get_core_native(const Request& request, Application& app);
Handled get_core_state(const Request& request, Application& app);
Handled get_derivations(const Request& request, Application& app);
Handled get_core_script(const Request& request, Application& app);
Handled get_core_journal(const Request& request, Application& app);
Handled get_why(const Request& request, Application& app);
Handled get_cell(const Request& request, Application& app);
Handled get_person(const Request& request, Application& app);
Handled execute_person_command(const Request& request, Application& app);
Handled get_cell_file(const Request& request, Application& app);

// For the handlers.

/// 200 with a body.
Reply ok(Value body);
/// A list of errors with one.
tl::unexpected<std::vector<Error>> failed(Error error);
/// The core of the route's `id`, or `not_found`.
Checked<std::shared_ptr<Core>> core_of(const Request& request, Application& app);
/// The world of the cell, or `not_found`.
Checked<CellWorld*> world_of(Application& app);
/// The answer of a core or the cell, or its error.
Handled answer(Expected<Value> value);

}  // namespace race::server
