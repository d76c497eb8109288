// One handler for each route of api/openapi.yaml, in a file of its name: takes a parsed request and the resources that
// it uses, returns a value. Sockets, limits and rights wrap them in one place.
//
// Threads: any thread of the handlers' pool; a handler may wait for a core.
#pragma once

#include <memory>
#include <optional>

#include "core/value/expected.h"
#include "core/value/fields.h"
#include "server/http/message.h"

namespace race::server {

class Backups;
class BootList;
class Cell;
class CellWorld;
class Core;
class Cores;
class Documents;
class Editing;
class IdempotentAnswers;
class LiveEdits;
class Runs;
class Samples;
class Worker;

using Handled = Checked<Reply>;

Handled get_health(const Request& request, Cell& cell);
Handled get_rules(const Request& request);
Handled list_documents(const Request& request, Documents& documents);
Handled get_document(const Request& request, Documents& documents);
Handled put_document(const Request& request, Editing& editing);
Handled delete_document(const Request& request, Editing& editing, Cores& cores, BootList& boot);
Handled edit_document(const Request& request, Editing& editing);
Handled get_revisions(const Request& request, Documents& documents);
Handled get_revision(const Request& request, Documents& documents);
Handled restore_document(const Request& request, Editing& editing);
Handled branch_document(const Request& request, Editing& editing);
Handled get_document_native(const Request& request, Documents& documents);
Handled list_backups(const Request& request, Backups& backups);
Handled get_backup(const Request& request, Backups& backups);
Handled create_backup(const Request& request, Backups& backups);
Handled delete_backup(const Request& request, Backups& backups);
Handled restore_backup(const Request& request, Backups& backups, Cores& cores, Editing& editing,
                       IdempotentAnswers& answers);
Handled list_services(const Request& request, Cell& cell);
Handled list_cores(const Request& request, Cores& cores);
Handled create_core(const Request& request, Documents& documents, Cores& cores, LiveEdits& edits);
Handled get_core(const Request& request, Cores& cores);
Handled delete_core(const Request& request, Cores& cores);
Handled load_core(const Request& request, Documents& documents, Cores& cores, LiveEdits& edits);
Handled start_core(const Request& request, Documents& documents, Cores& cores);
Handled pause_core(const Request& request, Cores& cores);
Handled resume_core(const Request& request, Cores& cores);
Handled stop_core(const Request& request, Cores& cores);
Handled step_core(const Request& request, Cores& cores);
Handled set_breakpoints(const Request& request, Cores& cores);
Handled set_core_live(const Request& request, Cores& cores, LiveEdits& edits);
Handled force_core(const Request& request, Cores& cores);
Handled get_core_native(const Request& request, Cores& cores);
Handled get_core_state(const Request& request, Cores& cores);
Handled get_derivations(const Request& request, Cores& cores);
Handled get_core_script(const Request& request, Cores& cores, Runs& runs);
Handled get_core_journal(const Request& request, Cores& cores, Runs& runs);
Handled get_why(const Request& request, Cores& cores);
Handled list_runs(const Request& request, Runs& runs);
Handled import_run(const Request& request, Runs& runs, Samples& samples, Worker& replays);
Handled get_run(const Request& request, Runs& runs);
Handled delete_run(const Request& request, Runs& runs, Cores& cores);
Handled get_run_native(const Request& request, Runs& runs);
Handled get_run_derivations(const Request& request, Runs& runs, Worker& replays);
Handled get_run_journal(const Request& request, Runs& runs);
Handled get_run_script(const Request& request, Runs& runs);
Handled get_run_samples(const Request& request, Runs& runs, Samples& samples);
Handled get_run_export(const Request& request, Runs& runs, Samples& samples, Documents& documents);
Handled compare_run(const Request& request, Runs& runs, Worker& replays);
Handled get_cell(const Request& request, Cell& cell);
Handled get_person(const Request& request, Cell& cell);
Handled execute_person_command(const Request& request, Cell& cell);
Handled get_cell_file(const Request& request, Cell& cell);
Handled get_boot(const Request& request, BootList& boot);
Handled put_boot(const Request& request, Documents& documents, BootList& boot);

// For the handlers.

/// 200 with a body.
Reply ok(Value body);
/// 201 with a body, of what is at `path` from now on.
Reply created(Value body, std::string path);
/// A list of errors with one.
tl::unexpected<std::vector<Error>> failed(Error error);
/// The field `arguments`: an object. Nothing if it is absent or, which is a violation, something else.
std::optional<Dict> read_arguments(Fields& fields);
/// The core of the route's `id`, or `not_found`.
Checked<std::shared_ptr<Core>> core_of(const Request& request, const Cores& cores);
/// The world of the cell, or `not_found`.
Checked<CellWorld*> world_of(Cell& cell);
/// The answer of a core or the cell, or its error.
Handled answer(Expected<Value> value);

}  // namespace race::server
