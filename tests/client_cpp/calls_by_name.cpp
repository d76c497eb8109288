// The functions of calls.h by the names of their operations, for conversations. Made by api/python/generate/main.py.
// clang-format off
#include "tests/client_cpp/calls_by_name.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>

#include "api/cpp/client/calls.h"

namespace race::client {
namespace {

struct NamedCall {
  std::string_view operation;
  Call (*call)(const Given& given);
};

constexpr NamedCall kCalls[] = {
    {"getHealth", [](const Given&) {
       return calls::get_health();
     }},
    {"getMetrics", [](const Given&) {
       return calls::get_metrics();
     }},
    {"getMe", [](const Given&) {
       return calls::get_me();
     }},
    {"changePassword", [](const Given& given) {
       return calls::change_password(given.body());
     }},
    {"logIn", [](const Given& given) {
       return calls::log_in(given.body());
     }},
    {"logOut", [](const Given&) {
       return calls::log_out();
     }},
    {"createTicket", [](const Given&) {
       return calls::create_ticket();
     }},
    {"createPairing", [](const Given& given) {
       return calls::create_pairing(given.body());
     }},
    {"pair", [](const Given& given) {
       return calls::pair(given.body());
     }},
    {"getAddresses", [](const Given&) {
       return calls::get_addresses();
     }},
    {"listAccounts", [](const Given&) {
       return calls::list_accounts();
     }},
    {"createAccount", [](const Given& given) {
       return calls::create_account(given.body());
     }},
    {"changeAccount", [](const Given& given) {
       return calls::change_account(given.text("name"), given.body());
     }},
    {"deleteAccount", [](const Given& given) {
       return calls::delete_account(given.text("name"));
     }},
    {"listTokens", [](const Given& given) {
       return calls::list_tokens(given.text("name"));
     }},
    {"createToken", [](const Given& given) {
       return calls::create_token(given.text("name"), given.body());
     }},
    {"revokeToken", [](const Given& given) {
       return calls::revoke_token(given.text("name"), given.text("digest"));
     }},
    {"getAuthority", [](const Given&) {
       return calls::get_authority();
     }},
    {"stopCell", [](const Given&) {
       return calls::stop_cell();
     }},
    {"resetStop", [](const Given&) {
       return calls::reset_stop();
     }},
    {"getControl", [](const Given&) {
       return calls::get_control();
     }},
    {"answerControlRequest", [](const Given& given) {
       return calls::answer_control_request(given.body());
     }},
    {"setCellMode", [](const Given& given) {
       return calls::set_cell_mode(given.body(), {.race_control = given.text_if("Race-Control")});
     }},
    {"getAudit", [](const Given& given) {
       return calls::get_audit({.before = given.integer_if("before"), .limit = given.integer_if("limit")});
     }},
    {"getRules", [](const Given&) {
       return calls::get_rules();
     }},
    {"listDocuments", [](const Given& given) {
       return calls::list_documents({.after = given.text_if("after"), .limit = given.integer_if("limit")});
     }},
    {"getDocument", [](const Given& given) {
       return calls::get_document(given.text("name"), {.if_none_match = given.text_if("If-None-Match")});
     }},
    {"putDocument", [](const Given& given) {
       return calls::put_document(given.text("name"), given.body(), {.draft = given.flag_if("draft"),
                                  .author = given.text_if("author"), .message = given.text_if("message"),
                                  .revision = given.integer_if("revision"), .if_match = given.text_if("If-Match"),
                                  .if_none_match = given.text_if("If-None-Match")});
     }},
    {"deleteDocument", [](const Given& given) {
       return calls::delete_document(given.text("name"), {.if_match = given.text_if("If-Match")});
     }},
    {"editDocument", [](const Given& given) {
       return calls::edit_document(given.text("name"), given.body(), {.if_match = given.text_if("If-Match")});
     }},
    {"listRevisions", [](const Given& given) {
       return calls::list_revisions(given.text("name"), {.before = given.integer_if("before"),
                                    .limit = given.integer_if("limit")});
     }},
    {"getRevision", [](const Given& given) {
       return calls::get_revision(given.text("name"), given.integer("revision"),
                                  {.if_none_match = given.text_if("If-None-Match")});
     }},
    {"restoreDocument", [](const Given& given) {
       return calls::restore_document(given.text("name"), given.body(), {.if_match = given.text_if("If-Match")});
     }},
    {"branchDocument", [](const Given& given) {
       return calls::branch_document(given.text("name"), given.body(),
                                     {.idempotency_key = given.text_if("Idempotency-Key")});
     }},
    {"getDocumentBreakpoints", [](const Given& given) {
       return calls::get_document_breakpoints(given.text("name"), given.text("author"));
     }},
    {"putDocumentBreakpoints", [](const Given& given) {
       return calls::put_document_breakpoints(given.text("name"), given.text("author"), given.body());
     }},
    {"getDocumentNative", [](const Given& given) {
       return calls::get_document_native(given.text("name"));
     }},
    {"getDocumentBundle", [](const Given& given) {
       return calls::get_document_bundle(given.text("name"));
     }},
    {"installBundle", [](const Given& given) {
       return calls::install_bundle(given.body(), {.as = given.text_if("as"), .author = given.text_if("author"),
                                    .message = given.text_if("message"), .if_match = given.text_if("If-Match"),
                                    .idempotency_key = given.text_if("Idempotency-Key")});
     }},
    {"proposeDocument", [](const Given& given) {
       return calls::propose_document(given.text("name"), given.body(), {.author = given.text_if("author"),
                                      .idempotency_key = given.text_if("Idempotency-Key")});
     }},
    {"listProposals", [](const Given& given) {
       return calls::list_proposals({.document = given.text_if("document"), .status = given.text_if("status"),
                                    .after = given.text_if("after"), .limit = given.integer_if("limit")});
     }},
    {"getProposal", [](const Given& given) {
       return calls::get_proposal(given.text("id"));
     }},
    {"withdrawProposal", [](const Given& given) {
       return calls::withdraw_proposal(given.text("id"), {.author = given.text_if("author")});
     }},
    {"acceptProposal", [](const Given& given) {
       return calls::accept_proposal(given.text("id"), {.author = given.text_if("author")});
     }},
    {"declineProposal", [](const Given& given) {
       return calls::decline_proposal(given.text("id"), given.body_if(), {.author = given.text_if("author")});
     }},
    {"listBackups", [](const Given&) {
       return calls::list_backups();
     }},
    {"createBackup", [](const Given& given) {
       return calls::create_backup({.idempotency_key = given.text_if("Idempotency-Key")});
     }},
    {"createBackupTask", [](const Given& given) {
       return calls::create_backup_task({.idempotency_key = given.text_if("Idempotency-Key")});
     }},
    {"getBackup", [](const Given& given) {
       return calls::get_backup(given.text("name"));
     }},
    {"deleteBackup", [](const Given& given) {
       return calls::delete_backup(given.text("name"));
     }},
    {"restoreBackup", [](const Given& given) {
       return calls::restore_backup(given.text("name"));
     }},
    {"restoreBackupTask", [](const Given& given) {
       return calls::restore_backup_task(given.text("name"));
     }},
    {"listServices", [](const Given&) {
       return calls::list_services();
     }},
    {"callService", [](const Given& given) {
       return calls::call_service(given.text("service"), given.body(), {.race_control = given.text_if("Race-Control")});
     }},
    {"listCores", [](const Given&) {
       return calls::list_cores();
     }},
    {"createCore", [](const Given& given) {
       return calls::create_core(given.body(), {.idempotency_key = given.text_if("Idempotency-Key")});
     }},
    {"getCore", [](const Given& given) {
       return calls::get_core(given.text("id"));
     }},
    {"deleteCore", [](const Given& given) {
       return calls::delete_core(given.text("id"));
     }},
    {"loadCore", [](const Given& given) {
       return calls::load_core(given.text("id"), given.body());
     }},
    {"startCore", [](const Given& given) {
       return calls::start_core(given.text("id"), given.body_if(), {.race_control = given.text_if("Race-Control")});
     }},
    {"pauseCore", [](const Given& given) {
       return calls::pause_core(given.text("id"));
     }},
    {"resumeCore", [](const Given& given) {
       return calls::resume_core(given.text("id"), given.body_if(), {.race_control = given.text_if("Race-Control")});
     }},
    {"stopCore", [](const Given& given) {
       return calls::stop_core(given.text("id"));
     }},
    {"stepCore", [](const Given& given) {
       return calls::step_core(given.text("id"), given.body(), {.race_control = given.text_if("Race-Control")});
     }},
    {"confirmCoreEdit", [](const Given& given) {
       return calls::confirm_core_edit(given.text("id"), given.body(), {.race_control = given.text_if("Race-Control")});
     }},
    {"setBreakpoints", [](const Given& given) {
       return calls::set_breakpoints(given.text("id"), given.body(), {.author = given.text_if("author")});
     }},
    {"setCoreLive", [](const Given& given) {
       return calls::set_core_live(given.text("id"), given.body());
     }},
    {"forceCore", [](const Given& given) {
       return calls::force_core(given.text("id"), given.body(), {.race_control = given.text_if("Race-Control")});
     }},
    {"getCoreNative", [](const Given& given) {
       return calls::get_core_native(given.text("id"));
     }},
    {"getCoreState", [](const Given& given) {
       return calls::get_core_state(given.text("id"));
     }},
    {"getDerivations", [](const Given& given) {
       return calls::get_derivations(given.text("id"), {.from = given.integer_if("from"),
                                     .to = given.integer_if("to")});
     }},
    {"getCoreScript", [](const Given& given) {
       return calls::get_core_script(given.text("id"));
     }},
    {"getCoreJournal", [](const Given& given) {
       return calls::get_core_journal(given.text("id"));
     }},
    {"getWhy", [](const Given& given) {
       return calls::get_why(given.text("id"), {.port = given.text_if("port"), .state = given.text_if("state"),
                             .action = given.integer_if("action"), .parameter = given.text_if("parameter"),
                             .step = given.integer_if("step"), .micro = given.integer_if("micro")});
     }},
    {"getPast", [](const Given& given) {
       return calls::get_past(given.text("id"), given.integer("step"), {.micro = given.integer_if("micro")});
     }},
    {"listQueue", [](const Given& given) {
       return calls::list_queue({.after = given.integer_if("after"), .limit = given.integer_if("limit")});
     }},
    {"queueRun", [](const Given& given) {
       return calls::queue_run(given.body(), {.idempotency_key = given.text_if("Idempotency-Key"),
                               .race_control = given.text_if("Race-Control")});
     }},
    {"resumeQueue", [](const Given&) {
       return calls::resume_queue();
     }},
    {"getQueuedRun", [](const Given& given) {
       return calls::get_queued_run(given.text("id"));
     }},
    {"cancelQueuedRun", [](const Given& given) {
       return calls::cancel_queued_run(given.text("id"));
     }},
    {"listRuns", [](const Given& given) {
       return calls::list_runs({.document = given.text_if("document"), .before = given.integer_if("before"),
                               .limit = given.integer_if("limit")});
     }},
    {"importRun", [](const Given& given) {
       return calls::import_run(given.body(), {.idempotency_key = given.text_if("Idempotency-Key")});
     }},
    {"importRunTask", [](const Given& given) {
       return calls::import_run_task(given.body(), {.idempotency_key = given.text_if("Idempotency-Key")});
     }},
    {"getRun", [](const Given& given) {
       return calls::get_run(given.text("run"));
     }},
    {"deleteRun", [](const Given& given) {
       return calls::delete_run(given.text("run"));
     }},
    {"getRunNative", [](const Given& given) {
       return calls::get_run_native(given.text("run"));
     }},
    {"getRunDerivations", [](const Given& given) {
       return calls::get_run_derivations(given.text("run"), {.from = given.integer_if("from"),
                                         .to = given.integer_if("to")});
     }},
    {"getRunPast", [](const Given& given) {
       return calls::get_run_past(given.text("run"), given.integer("step"), {.micro = given.integer_if("micro")});
     }},
    {"getRunWhy", [](const Given& given) {
       return calls::get_run_why(given.text("run"), {.port = given.text_if("port"), .state = given.text_if("state"),
                                 .action = given.integer_if("action"), .parameter = given.text_if("parameter"),
                                 .step = given.integer_if("step"), .micro = given.integer_if("micro")});
     }},
    {"getRunJournal", [](const Given& given) {
       return calls::get_run_journal(given.text("run"));
     }},
    {"getRunScript", [](const Given& given) {
       return calls::get_run_script(given.text("run"));
     }},
    {"getRunSamples", [](const Given& given) {
       return calls::get_run_samples(given.text("run"));
     }},
    {"getRunPictures", [](const Given& given) {
       return calls::get_run_pictures(given.text("run"));
     }},
    {"getRunPicture", [](const Given& given) {
       return calls::get_run_picture(given.text("run"), given.integer("number"));
     }},
    {"getRunTiming", [](const Given& given) {
       return calls::get_run_timing(given.text("run"), {.from = given.integer_if("from"),
                                    .to = given.integer_if("to")});
     }},
    {"exportRun", [](const Given& given) {
       return calls::export_run(given.text("run"));
     }},
    {"getRunTest", [](const Given& given) {
       return calls::get_run_test(given.text("run"));
     }},
    {"compareRun", [](const Given& given) {
       return calls::compare_run(given.text("run"), given.text("with"), {.from = given.integer_if("from")});
     }},
    {"getTask", [](const Given& given) {
       return calls::get_task(given.text("id"));
     }},
    {"cancelTask", [](const Given& given) {
       return calls::cancel_task(given.text("id"));
     }},
    {"getBoot", [](const Given&) {
       return calls::get_boot();
     }},
    {"putBoot", [](const Given& given) {
       return calls::put_boot(given.body());
     }},
    {"getCell", [](const Given&) {
       return calls::get_cell();
     }},
    {"getPerson", [](const Given&) {
       return calls::get_person();
     }},
    {"commandPerson", [](const Given& given) {
       return calls::command_person(given.body());
     }},
    {"resetCell", [](const Given& given) {
       return calls::reset_cell(given.body_if(), {.race_control = given.text_if("Race-Control")});
     }},
    {"getCellFile", [](const Given& given) {
       return calls::get_cell_file(given.text("file"));
     }},
};

}  // namespace

Call call_by_name(std::string_view operation, const Given& given) {
  const auto* const found = std::ranges::find(kCalls, operation, &NamedCall::operation);
  if (found == std::end(kCalls)) throw std::invalid_argument("no operation is named " + std::string(operation));
  return found->call(given);
}

}  // namespace race::client
