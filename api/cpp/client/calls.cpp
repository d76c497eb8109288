// Made by api/python/generate/main.py.
// clang-format off
#include "api/cpp/client/calls.h"

namespace race::client::calls {

Call get_health() {
  Call call{.method = "GET", .target = "/api/v1/health"};
  return call;
}

Call get_metrics() {
  Call call{.method = "GET", .target = "/metrics"};
  call.is_text = true;
  return call;
}

Call get_me() {
  Call call{.method = "GET", .target = "/api/v1/me"};
  return call;
}

Call change_password(const Value& body) {
  Call call{.method = "PUT", .target = "/api/v1/me/password"};
  call.body = body;
  return call;
}

Call log_in(const Value& body) {
  Call call{.method = "POST", .target = "/api/v1/login"};
  call.body = body;
  return call;
}

Call log_out() {
  Call call{.method = "POST", .target = "/api/v1/logout"};
  return call;
}

Call create_ticket() {
  Call call{.method = "POST", .target = "/api/v1/tickets"};
  return call;
}

Call create_pairing(const Value& body) {
  Call call{.method = "POST", .target = "/api/v1/pairings"};
  call.body = body;
  return call;
}

Call pair(const Value& body) {
  Call call{.method = "POST", .target = "/api/v1/pair"};
  call.body = body;
  return call;
}

Call get_addresses() {
  Call call{.method = "GET", .target = "/api/v1/addresses"};
  return call;
}

Call list_accounts() {
  Call call{.method = "GET", .target = "/api/v1/accounts"};
  return call;
}

Call create_account(const Value& body) {
  Call call{.method = "POST", .target = "/api/v1/accounts"};
  call.body = body;
  return call;
}

Call change_account(std::string_view name, const Value& body) {
  Call call{.method = "PUT", .target = "/api/v1/accounts/" + segment(name)};
  call.body = body;
  return call;
}

Call delete_account(std::string_view name) {
  Call call{.method = "DELETE", .target = "/api/v1/accounts/" + segment(name)};
  return call;
}

Call list_tokens(std::string_view name) {
  Call call{.method = "GET", .target = "/api/v1/accounts/" + segment(name) + "/tokens"};
  return call;
}

Call create_token(std::string_view name, const Value& body) {
  Call call{.method = "POST", .target = "/api/v1/accounts/" + segment(name) + "/tokens"};
  call.body = body;
  return call;
}

Call revoke_token(std::string_view name, std::string_view digest) {
  Call call{.method = "DELETE", .target = "/api/v1/accounts/" + segment(name) + "/tokens/" + segment(digest)};
  return call;
}

Call get_authority() {
  Call call{.method = "GET", .target = "/api/v1/authority"};
  call.is_text = true;
  return call;
}

Call stop_cell() {
  Call call{.method = "POST", .target = "/api/v1/stop"};
  return call;
}

Call reset_stop() {
  Call call{.method = "POST", .target = "/api/v1/stop/reset"};
  return call;
}

Call get_control() {
  Call call{.method = "GET", .target = "/api/v1/control"};
  return call;
}

Call answer_control_request(const Value& body) {
  Call call{.method = "POST", .target = "/api/v1/control/answer"};
  call.body = body;
  return call;
}

Call set_cell_mode(const Value& body, const SetCellModeOptions& options) {
  Call call{.method = "PUT", .target = "/api/v1/control/mode"};
  add_header(call, "Race-Control", options.race_control);
  call.body = body;
  return call;
}

Call get_audit(const GetAuditOptions& options) {
  Call call{.method = "GET", .target = "/api/v1/audit"};
  add_query(call, "before", options.before);
  add_query(call, "limit", options.limit);
  return call;
}

Call get_rules() {
  Call call{.method = "GET", .target = "/api/v1/rules"};
  return call;
}

Call list_documents(const ListDocumentsOptions& options) {
  Call call{.method = "GET", .target = "/api/v1/documents"};
  add_query(call, "after", options.after);
  add_query(call, "limit", options.limit);
  return call;
}

Call get_document(std::string_view name, const GetDocumentOptions& options) {
  Call call{.method = "GET", .target = "/api/v1/documents/" + segment(name)};
  add_header(call, "If-None-Match", options.if_none_match);
  return call;
}

Call put_document(std::string_view name, const Value& body, const PutDocumentOptions& options) {
  Call call{.method = "PUT", .target = "/api/v1/documents/" + segment(name)};
  add_query(call, "draft", options.draft);
  add_query(call, "author", options.author);
  add_query(call, "message", options.message);
  add_query(call, "revision", options.revision);
  add_header(call, "If-Match", options.if_match);
  add_header(call, "If-None-Match", options.if_none_match);
  call.body = body;
  return call;
}

Call delete_document(std::string_view name, const DeleteDocumentOptions& options) {
  Call call{.method = "DELETE", .target = "/api/v1/documents/" + segment(name)};
  add_header(call, "If-Match", options.if_match);
  return call;
}

Call edit_document(std::string_view name, const Value& body, const EditDocumentOptions& options) {
  Call call{.method = "POST", .target = "/api/v1/documents/" + segment(name) + "/edits"};
  add_header(call, "If-Match", options.if_match);
  call.body = body;
  return call;
}

Call list_revisions(std::string_view name, const ListRevisionsOptions& options) {
  Call call{.method = "GET", .target = "/api/v1/documents/" + segment(name) + "/revisions"};
  add_query(call, "before", options.before);
  add_query(call, "limit", options.limit);
  return call;
}

Call get_revision(std::string_view name, std::int64_t revision, const GetRevisionOptions& options) {
  Call call{.method = "GET", .target = "/api/v1/documents/" + segment(name) + "/revisions/" + segment(revision)};
  add_header(call, "If-None-Match", options.if_none_match);
  return call;
}

Call restore_document(std::string_view name, const Value& body, const RestoreDocumentOptions& options) {
  Call call{.method = "POST", .target = "/api/v1/documents/" + segment(name) + "/restore"};
  add_header(call, "If-Match", options.if_match);
  call.body = body;
  return call;
}

Call branch_document(std::string_view name, const Value& body, const BranchDocumentOptions& options) {
  Call call{.method = "POST", .target = "/api/v1/documents/" + segment(name) + "/branch"};
  add_header(call, "Idempotency-Key", options.idempotency_key);
  call.body = body;
  return call;
}

Call get_document_breakpoints(std::string_view name, std::string_view author) {
  Call call{.method = "GET", .target = "/api/v1/documents/" + segment(name) + "/breakpoints"};
  add_query(call, "author", author);
  return call;
}

Call put_document_breakpoints(std::string_view name, std::string_view author, const Value& body) {
  Call call{.method = "PUT", .target = "/api/v1/documents/" + segment(name) + "/breakpoints"};
  add_query(call, "author", author);
  call.body = body;
  return call;
}

Call get_document_native(std::string_view name) {
  Call call{.method = "GET", .target = "/api/v1/documents/" + segment(name) + "/native"};
  return call;
}

Call get_document_bundle(std::string_view name) {
  Call call{.method = "GET", .target = "/api/v1/documents/" + segment(name) + "/bundle"};
  return call;
}

Call install_bundle(const Value& body, const InstallBundleOptions& options) {
  Call call{.method = "POST", .target = "/api/v1/bundles"};
  add_query(call, "as", options.as);
  add_query(call, "author", options.author);
  add_query(call, "message", options.message);
  add_header(call, "If-Match", options.if_match);
  add_header(call, "Idempotency-Key", options.idempotency_key);
  call.body = body;
  return call;
}

Call propose_document(std::string_view name, const Value& body, const ProposeDocumentOptions& options) {
  Call call{.method = "POST", .target = "/api/v1/documents/" + segment(name) + "/proposals"};
  add_query(call, "author", options.author);
  add_header(call, "Idempotency-Key", options.idempotency_key);
  call.body = body;
  return call;
}

Call list_proposals(const ListProposalsOptions& options) {
  Call call{.method = "GET", .target = "/api/v1/proposals"};
  add_query(call, "document", options.document);
  add_query(call, "status", options.status);
  add_query(call, "after", options.after);
  add_query(call, "limit", options.limit);
  return call;
}

Call get_proposal(std::string_view id) {
  Call call{.method = "GET", .target = "/api/v1/proposals/" + segment(id)};
  return call;
}

Call withdraw_proposal(std::string_view id, const WithdrawProposalOptions& options) {
  Call call{.method = "DELETE", .target = "/api/v1/proposals/" + segment(id)};
  add_query(call, "author", options.author);
  return call;
}

Call accept_proposal(std::string_view id, const AcceptProposalOptions& options) {
  Call call{.method = "POST", .target = "/api/v1/proposals/" + segment(id) + "/accept"};
  add_query(call, "author", options.author);
  return call;
}

Call decline_proposal(std::string_view id, const std::optional<Value>& body, const DeclineProposalOptions& options) {
  Call call{.method = "POST", .target = "/api/v1/proposals/" + segment(id) + "/decline"};
  add_query(call, "author", options.author);
  call.body = body;
  return call;
}

Call list_backups() {
  Call call{.method = "GET", .target = "/api/v1/backups"};
  return call;
}

Call create_backup(const CreateBackupOptions& options) {
  Call call{.method = "POST", .target = "/api/v1/backups"};
  add_header(call, "Idempotency-Key", options.idempotency_key);
  return call;
}

Call create_backup_task(const CreateBackupTaskOptions& options) {
  Call call{.method = "POST", .target = "/api/v1/backups"};
  add_header(call, "Idempotency-Key", options.idempotency_key);
  add_header(call, "Prefer", "respond-async");
  return call;
}

Call get_backup(std::string_view name) {
  Call call{.method = "GET", .target = "/api/v1/backups/" + segment(name)};
  return call;
}

Call delete_backup(std::string_view name) {
  Call call{.method = "DELETE", .target = "/api/v1/backups/" + segment(name)};
  return call;
}

Call restore_backup(std::string_view name) {
  Call call{.method = "POST", .target = "/api/v1/backups/" + segment(name) + "/restore"};
  return call;
}

Call restore_backup_task(std::string_view name) {
  Call call{.method = "POST", .target = "/api/v1/backups/" + segment(name) + "/restore"};
  add_header(call, "Prefer", "respond-async");
  return call;
}

Call list_services() {
  Call call{.method = "GET", .target = "/api/v1/services"};
  return call;
}

Call call_service(std::string_view service, const Value& body, const CallServiceOptions& options) {
  Call call{.method = "POST", .target = "/api/v1/services/" + segment(service) + "/calls"};
  add_header(call, "Race-Control", options.race_control);
  call.body = body;
  return call;
}

Call list_cores() {
  Call call{.method = "GET", .target = "/api/v1/cores"};
  return call;
}

Call create_core(const Value& body, const CreateCoreOptions& options) {
  Call call{.method = "POST", .target = "/api/v1/cores"};
  add_header(call, "Idempotency-Key", options.idempotency_key);
  call.body = body;
  return call;
}

Call get_core(std::string_view id) {
  Call call{.method = "GET", .target = "/api/v1/cores/" + segment(id)};
  return call;
}

Call delete_core(std::string_view id) {
  Call call{.method = "DELETE", .target = "/api/v1/cores/" + segment(id)};
  return call;
}

Call load_core(std::string_view id, const Value& body) {
  Call call{.method = "POST", .target = "/api/v1/cores/" + segment(id) + "/load"};
  call.body = body;
  return call;
}

Call start_core(std::string_view id, const std::optional<Value>& body, const StartCoreOptions& options) {
  Call call{.method = "POST", .target = "/api/v1/cores/" + segment(id) + "/start"};
  add_header(call, "Race-Control", options.race_control);
  call.body = body;
  return call;
}

Call pause_core(std::string_view id) {
  Call call{.method = "POST", .target = "/api/v1/cores/" + segment(id) + "/pause"};
  return call;
}

Call resume_core(std::string_view id, const std::optional<Value>& body, const ResumeCoreOptions& options) {
  Call call{.method = "POST", .target = "/api/v1/cores/" + segment(id) + "/resume"};
  add_header(call, "Race-Control", options.race_control);
  call.body = body;
  return call;
}

Call stop_core(std::string_view id) {
  Call call{.method = "POST", .target = "/api/v1/cores/" + segment(id) + "/stop"};
  return call;
}

Call step_core(std::string_view id, const Value& body, const StepCoreOptions& options) {
  Call call{.method = "POST", .target = "/api/v1/cores/" + segment(id) + "/step"};
  add_header(call, "Race-Control", options.race_control);
  call.body = body;
  return call;
}

Call confirm_core_edit(std::string_view id, const Value& body, const ConfirmCoreEditOptions& options) {
  Call call{.method = "POST", .target = "/api/v1/cores/" + segment(id) + "/confirm_edit"};
  add_header(call, "Race-Control", options.race_control);
  call.body = body;
  return call;
}

Call set_breakpoints(std::string_view id, const Value& body, const SetBreakpointsOptions& options) {
  Call call{.method = "PUT", .target = "/api/v1/cores/" + segment(id) + "/breakpoints"};
  add_query(call, "author", options.author);
  call.body = body;
  return call;
}

Call set_core_live(std::string_view id, const Value& body) {
  Call call{.method = "PUT", .target = "/api/v1/cores/" + segment(id) + "/live"};
  call.body = body;
  return call;
}

Call force_core(std::string_view id, const Value& body, const ForceCoreOptions& options) {
  Call call{.method = "POST", .target = "/api/v1/cores/" + segment(id) + "/force"};
  add_header(call, "Race-Control", options.race_control);
  call.body = body;
  return call;
}

Call get_core_native(std::string_view id) {
  Call call{.method = "GET", .target = "/api/v1/cores/" + segment(id) + "/native"};
  return call;
}

Call get_core_state(std::string_view id) {
  Call call{.method = "GET", .target = "/api/v1/cores/" + segment(id) + "/state"};
  return call;
}

Call get_derivations(std::string_view id, const GetDerivationsOptions& options) {
  Call call{.method = "GET", .target = "/api/v1/cores/" + segment(id) + "/derivations"};
  add_query(call, "from", options.from);
  add_query(call, "to", options.to);
  return call;
}

Call get_core_script(std::string_view id) {
  Call call{.method = "GET", .target = "/api/v1/cores/" + segment(id) + "/script"};
  return call;
}

Call get_core_journal(std::string_view id) {
  Call call{.method = "GET", .target = "/api/v1/cores/" + segment(id) + "/journal"};
  return call;
}

Call get_why(std::string_view id, const GetWhyOptions& options) {
  Call call{.method = "GET", .target = "/api/v1/cores/" + segment(id) + "/why"};
  add_query(call, "port", options.port);
  add_query(call, "state", options.state);
  add_query(call, "action", options.action);
  add_query(call, "parameter", options.parameter);
  add_query(call, "step", options.step);
  add_query(call, "micro", options.micro);
  return call;
}

Call get_past(std::string_view id, std::int64_t step, const GetPastOptions& options) {
  Call call{.method = "GET", .target = "/api/v1/cores/" + segment(id) + "/past"};
  add_query(call, "step", step);
  add_query(call, "micro", options.micro);
  return call;
}

Call list_queue(const ListQueueOptions& options) {
  Call call{.method = "GET", .target = "/api/v1/queue"};
  add_query(call, "after", options.after);
  add_query(call, "limit", options.limit);
  return call;
}

Call queue_run(const Value& body, const QueueRunOptions& options) {
  Call call{.method = "POST", .target = "/api/v1/queue"};
  add_header(call, "Idempotency-Key", options.idempotency_key);
  add_header(call, "Race-Control", options.race_control);
  call.body = body;
  return call;
}

Call resume_queue() {
  Call call{.method = "POST", .target = "/api/v1/queue/resume"};
  return call;
}

Call get_queued_run(std::string_view id) {
  Call call{.method = "GET", .target = "/api/v1/queue/" + segment(id)};
  return call;
}

Call cancel_queued_run(std::string_view id) {
  Call call{.method = "DELETE", .target = "/api/v1/queue/" + segment(id)};
  return call;
}

Call list_runs(const ListRunsOptions& options) {
  Call call{.method = "GET", .target = "/api/v1/runs"};
  add_query(call, "document", options.document);
  add_query(call, "before", options.before);
  add_query(call, "limit", options.limit);
  return call;
}

Call import_run(const Value& body, const ImportRunOptions& options) {
  Call call{.method = "POST", .target = "/api/v1/runs"};
  add_header(call, "Idempotency-Key", options.idempotency_key);
  call.body = body;
  return call;
}

Call import_run_task(const Value& body, const ImportRunTaskOptions& options) {
  Call call{.method = "POST", .target = "/api/v1/runs"};
  add_header(call, "Idempotency-Key", options.idempotency_key);
  add_header(call, "Prefer", "respond-async");
  call.body = body;
  return call;
}

Call get_run(std::string_view run) {
  Call call{.method = "GET", .target = "/api/v1/runs/" + segment(run)};
  return call;
}

Call delete_run(std::string_view run) {
  Call call{.method = "DELETE", .target = "/api/v1/runs/" + segment(run)};
  return call;
}

Call get_run_native(std::string_view run) {
  Call call{.method = "GET", .target = "/api/v1/runs/" + segment(run) + "/native"};
  return call;
}

Call get_run_derivations(std::string_view run, const GetRunDerivationsOptions& options) {
  Call call{.method = "GET", .target = "/api/v1/runs/" + segment(run) + "/derivations"};
  add_query(call, "from", options.from);
  add_query(call, "to", options.to);
  return call;
}

Call get_run_past(std::string_view run, std::int64_t step, const GetRunPastOptions& options) {
  Call call{.method = "GET", .target = "/api/v1/runs/" + segment(run) + "/past"};
  add_query(call, "step", step);
  add_query(call, "micro", options.micro);
  return call;
}

Call get_run_why(std::string_view run, const GetRunWhyOptions& options) {
  Call call{.method = "GET", .target = "/api/v1/runs/" + segment(run) + "/why"};
  add_query(call, "port", options.port);
  add_query(call, "state", options.state);
  add_query(call, "action", options.action);
  add_query(call, "parameter", options.parameter);
  add_query(call, "step", options.step);
  add_query(call, "micro", options.micro);
  return call;
}

Call get_run_journal(std::string_view run) {
  Call call{.method = "GET", .target = "/api/v1/runs/" + segment(run) + "/journal"};
  return call;
}

Call get_run_script(std::string_view run) {
  Call call{.method = "GET", .target = "/api/v1/runs/" + segment(run) + "/script"};
  return call;
}

Call get_run_samples(std::string_view run) {
  Call call{.method = "GET", .target = "/api/v1/runs/" + segment(run) + "/samples"};
  return call;
}

Call get_run_pictures(std::string_view run) {
  Call call{.method = "GET", .target = "/api/v1/runs/" + segment(run) + "/pictures"};
  return call;
}

Call get_run_picture(std::string_view run, std::int64_t number) {
  Call call{.method = "GET", .target = "/api/v1/runs/" + segment(run) + "/pictures/" + segment(number)};
  return call;
}

Call get_run_timing(std::string_view run, const GetRunTimingOptions& options) {
  Call call{.method = "GET", .target = "/api/v1/runs/" + segment(run) + "/timing"};
  add_query(call, "from", options.from);
  add_query(call, "to", options.to);
  return call;
}

Call export_run(std::string_view run) {
  Call call{.method = "GET", .target = "/api/v1/runs/" + segment(run) + "/export"};
  return call;
}

Call get_run_test(std::string_view run) {
  Call call{.method = "GET", .target = "/api/v1/runs/" + segment(run) + "/test"};
  return call;
}

Call compare_run(std::string_view run, std::string_view with, const CompareRunOptions& options) {
  Call call{.method = "GET", .target = "/api/v1/runs/" + segment(run) + "/compare"};
  add_query(call, "with", with);
  add_query(call, "from", options.from);
  return call;
}

Call get_task(std::string_view id) {
  Call call{.method = "GET", .target = "/api/v1/tasks/" + segment(id)};
  return call;
}

Call cancel_task(std::string_view id) {
  Call call{.method = "DELETE", .target = "/api/v1/tasks/" + segment(id)};
  return call;
}

Call get_boot() {
  Call call{.method = "GET", .target = "/api/v1/boot"};
  return call;
}

Call put_boot(const Value& body) {
  Call call{.method = "PUT", .target = "/api/v1/boot"};
  call.body = body;
  return call;
}

Call get_cell() {
  Call call{.method = "GET", .target = "/api/v1/cell"};
  return call;
}

Call get_person() {
  Call call{.method = "GET", .target = "/api/v1/cell/person"};
  return call;
}

Call command_person(const Value& body) {
  Call call{.method = "POST", .target = "/api/v1/cell/person"};
  call.body = body;
  return call;
}

Call reset_cell(const std::optional<Value>& body, const ResetCellOptions& options) {
  Call call{.method = "POST", .target = "/api/v1/cell/reset"};
  add_header(call, "Race-Control", options.race_control);
  call.body = body;
  return call;
}

Call get_cell_file(std::string_view file) {
  Call call{.method = "GET", .target = "/api/v1/cell/" + segment(file)};
  call.is_text = true;
  return call;
}

}  // namespace race::client::calls
