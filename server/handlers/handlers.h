// One handler for each route of api/openapi.yaml, in a file of its name: takes a parsed request and the resources that
// it uses, returns a value. Those that need a core, the cell or a replay respond when it has come: no thread of theirs
// waits for it. Sockets, limits and rights wrap them in one place.
//
// Threads: any thread of the handlers' pool. A handler that responds later takes with it what it needs of the request.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "core/value/expected.h"
#include "core/value/fields.h"
#include "server/http/message.h"
#include "server/threads/done.h"

namespace race::server {

class Accounts;
struct AuthorityCertificate;
class Attempts;
class AuditLog;
class Backups;
class BootList;
class Cell;
class CellStop;
class CellWorld;
class Control;
class Core;
class Cores;
class Deadlines;
class DocumentBreakpoints;
class Documents;
class Editing;
class IdempotentAnswers;
class LiveEdits;
class ManualControl;
class Metrics;
struct NetworkAddresses;
class Pairings;
class Passwords;
class Pictures;
class Pool;
class Proposals;
class Proposing;
class RunQueue;
class Runs;
class Samples;
class Tasks;
class Tickets;
class Worker;

using Handled = Checked<Reply>;
/// Gets what a handler has to say, once; on any thread.
using Respond = std::function<void(Handled)>;

Handled get_health(const Request& request, Cell& cell);
Handled get_metrics(const Request& request, Metrics& metrics);
Handled get_me(const Request& request, Accounts& accounts);
void change_password(const Request& request, Respond respond, Accounts& accounts, Passwords& passwords,
                     Attempts& attempts);
void log_in(const Request& request, Respond respond, Accounts& accounts, Passwords& passwords, Attempts& attempts);
Handled log_out(const Request& request, Accounts& accounts);
Handled create_ticket(const Request& request, Tickets& tickets);
Handled create_pairing(const Request& request, Accounts& accounts, Pairings& pairings, NetworkAddresses& addresses);
Handled pair_display(const Request& request, Accounts& accounts, Pairings& pairings, Attempts& attempts);
Handled get_addresses(const Request& request, NetworkAddresses& addresses);
Handled list_accounts(const Request& request, Accounts& accounts);
void create_account(const Request& request, Respond respond, Accounts& accounts, Passwords& passwords);
void change_account(const Request& request, Respond respond, Accounts& accounts, Passwords& passwords);
Handled remove_account(const Request& request, Accounts& accounts);
Handled list_account_tokens(const Request& request, Accounts& accounts);
Handled create_account_token(const Request& request, Accounts& accounts);
Handled revoke_account_token(const Request& request, Accounts& accounts);
Handled get_authority(const Request& request, AuthorityCertificate& authority);
Handled get_audit(const Request& request, AuditLog& audit);
Handled stop_cell(const Request& request, CellStop& cell_stop, Control& control);
Handled reset_stop(const Request& request, CellStop& cell_stop, Control& control);
Handled get_control(const Request& request, Control& control, Accounts& accounts);
Handled answer_control_request(const Request& request, ManualControl& manual, Control& control);
Handled set_mode(const Request& request, CellStop& cell_stop, ManualControl& manual, Control& control);
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
Handled get_document_bundle(const Request& request, Documents& documents, Cell& cell);
Handled install_bundle(const Request& request, Editing& editing, Cell& cell);
Handled get_document_breakpoints(const Request& request, DocumentBreakpoints& breakpoints);
Handled put_document_breakpoints(const Request& request, DocumentBreakpoints& breakpoints);
Handled propose_document(const Request& request, Proposals& proposals, Proposing& proposing);
Handled list_proposals(const Request& request, Proposals& proposals);
Handled get_proposal(const Request& request, Proposals& proposals);
Handled accept_proposal(const Request& request, Proposing& proposing);
Handled decline_proposal(const Request& request, Proposing& proposing);
Handled withdraw_proposal(const Request& request, Proposals& proposals, Proposing& proposing);
Handled list_backups(const Request& request, Backups& backups);
Handled get_backup(const Request& request, Backups& backups);
void create_backup(const Request& request, Respond respond, Backups& backups, Pool& restores);
void delete_backup(const Request& request, Respond respond, Backups& backups, Pool& restores);
void restore_backup(const Request& request, Respond respond, Backups& backups, Cores& cores, Editing& editing,
                    IdempotentAnswers& answers, RunQueue& queue, Pool& restores);
Handled list_services(const Request& request, Cell& cell);
void call_service(const Request& request, Respond respond, ManualControl& manual);
Handled list_cores(const Request& request, Cores& cores);
Handled create_core(const Request& request, Documents& documents, Cores& cores, LiveEdits& edits);
Handled get_core(const Request& request, Cores& cores);
void delete_core(const Request& request, Respond respond, Cores& cores);
void load_core(const Request& request, Respond respond, Documents& documents, Cores& cores, LiveEdits& edits);
void start_core(const Request& request, Respond respond, Documents& documents, Cores& cores, ManualControl& manual);
void pause_core(const Request& request, Respond respond, Cores& cores);
void resume_core(const Request& request, Respond respond, Cores& cores, ManualControl& manual);
void stop_core(const Request& request, Respond respond, Cores& cores);
void step_core(const Request& request, Respond respond, Cores& cores, ManualControl& manual);
void confirm_core_edit(const Request& request, Respond respond, Cores& cores, ManualControl& manual);
void set_breakpoints(const Request& request, Respond respond, Cores& cores);
void set_core_live(const Request& request, Respond respond, Cores& cores, LiveEdits& edits);
void force_core(const Request& request, Respond respond, Cores& cores, ManualControl& manual);
void get_core_native(const Request& request, Respond respond, Cores& cores);
void get_core_state(const Request& request, Respond respond, Cores& cores);
Handled get_core_events(const Request& request, Cores& cores);
void get_derivations(const Request& request, Respond respond, Cores& cores);
Handled get_core_script(const Request& request, Cores& cores, Runs& runs);
Handled get_core_journal(const Request& request, Cores& cores, Runs& runs);
void get_why(const Request& request, Respond respond, Cores& cores);
void get_past(const Request& request, Respond respond, Cores& cores);
Handled list_queue(const Request& request, RunQueue& queue);
Handled create_queued_run(const Request& request, Documents& documents, Cores& cores, ManualControl& manual,
                          RunQueue& queue);
Handled resume_queue(const Request& request, RunQueue& queue);
Handled get_queued_run(const Request& request, RunQueue& queue);
Handled cancel_queued_run(const Request& request, RunQueue& queue);
Handled list_runs(const Request& request, Runs& runs);
void import_run(const Request& request, Respond respond, Runs& runs, Samples& samples, Pictures& pictures,
                Worker& replays);
Handled get_run(const Request& request, Runs& runs);
Handled delete_run(const Request& request, Runs& runs, Cores& cores);
Handled get_run_native(const Request& request, Runs& runs);
void get_run_derivations(const Request& request, Respond respond, Runs& runs, Worker& replays);
void get_run_past(const Request& request, Respond respond, Runs& runs, Worker& replays);
void get_run_why(const Request& request, Respond respond, Runs& runs, Worker& replays);
Handled get_run_journal(const Request& request, Runs& runs);
Handled get_run_script(const Request& request, Runs& runs);
Handled get_run_samples(const Request& request, Runs& runs, Samples& samples);
Handled get_run_pictures(const Request& request, Runs& runs, Pictures& pictures);
Handled get_run_picture(const Request& request, Runs& runs, Pictures& pictures);
Handled get_run_timing(const Request& request, Runs& runs, Cores& cores);
Handled get_run_export(const Request& request, Runs& runs, Samples& samples, Pictures& pictures, Documents& documents);
void get_run_test(const Request& request, Respond respond, Runs& runs, Worker& replays);
void compare_run(const Request& request, Respond respond, Runs& runs, Worker& replays);
Handled get_task(const Request& request, Tasks& tasks);
Handled cancel_task(const Request& request, Tasks& tasks);
Handled get_cell(const Request& request, Cell& cell, Control& control);
void get_person(const Request& request, Respond respond, Cell& cell, Deadlines& deadlines);
void execute_person_command(const Request& request, Respond respond, Cell& cell, Deadlines& deadlines);
void reset_cell(const Request& request, Respond respond, Cell& cell, Cores& cores, Control& control,
                ManualControl& manual, Deadlines& deadlines);
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
/// Responds with the answer of a core or the cell once it has come.
Done<Value> answer_to(Respond respond);

/// The same reply, which has no row of its own in the audit log if it is no refusal.
Respond as_routine(Respond respond);

}  // namespace race::server
