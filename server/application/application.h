// Application: the parts of `race serve` behind its sockets, put together: documents, cell, cores, stream, log.
//
// Threads: any.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "server/accounts/accounts.h"
#include "server/accounts/attempts.h"
#include "server/accounts/audit_log.h"
#include "server/accounts/gate.h"
#include "server/accounts/local_key.h"
#include "server/accounts/pairings.h"
#include "server/accounts/passwords.h"
#include "server/accounts/tickets.h"
#include "server/application/access.h"
#include "server/application/motion_end.h"
#include "server/cell/cell.h"
#include "server/cell/operator.h"
#include "server/channels/channels.h"
#include "server/channels/core_publisher.h"
#include "server/channels/document_publisher.h"
#include "server/channels/service_publisher.h"
#include "server/control/cell_stop.h"
#include "server/control/control.h"
#include "server/control/manual_control.h"
#include "server/editing/document_watcher.h"
#include "server/editing/edit_queue.h"
#include "server/editing/editing.h"
#include "server/editing/presence_channels.h"
#include "server/editing/proposing.h"
#include "server/execution/live_edits.h"
#include "server/handlers/authority_certificate.h"
#include "server/handlers/idempotency.h"
#include "server/handlers/network_addresses.h"
#include "server/handlers/routes.h"
#include "server/handlers/tasks.h"
#include "server/http/listener.h"
#include "server/log/event_log.h"
#include "server/metrics/metrics.h"
#include "server/queue/run_queue.h"
#include "server/runs/picture_recorder.h"
#include "server/runs/run_keeper.h"
#include "server/store/backup.h"
#include "server/store/boot_list.h"
#include "server/store/data_folder.h"
#include "server/store/document_breakpoints.h"
#include "server/store/documents.h"
#include "server/store/journal_writer.h"
#include "server/store/proposals.h"
#include "server/store/runs.h"
#include "server/stream/displays.h"
#include "server/stream/flow_channels.h"
#include "server/stream/hub.h"
#include "server/threads/deadlines.h"
#include "server/threads/memory_return.h"
#include "server/threads/strand.h"
#include "server/threads/worker.h"
#include "services/display/screens.h"

namespace race::server {

class Application {
 public:
  struct Setup {
    std::string data;  // folder of all that the server keeps (store/data_folder.h)
    std::string demo;  // folder with scene.json, database.json and *.rcm.json; may be empty
    std::int64_t first_sequence = 1;
    std::vector<ExtraService> extra_services = {};
    std::optional<OperatorScript> script = {};  // begins anew with each run that is started
    std::vector<std::string> remote = {};       // as of CellSetup
    std::chrono::milliseconds heartbeat{1000};  // of their processes
    RetentionLimits retention = {};
    PasswordCost password_cost = {};
    LineLog* lines = nullptr;  // gets the lines of the log; outlives the application
  };
  static Checked<std::unique_ptr<Application>> create(const Setup& setup);
  ~Application();

  /// What the sockets serve; the application outlives it.
  Backend make_backend();
  /// Whether anybody has an account.
  bool has_accounts() const { return !accounts_->empty(); }
  /// The authority that has signed for this server, whose certificate clients may have (GET /api/v1/authority); before
  /// the sockets begin.
  void set_authority(std::string certificate, std::string fingerprint) {
    authority_ = {std::move(certificate), std::move(fingerprint)};
  }
  /// Where the network reaches this server (GET /api/v1/addresses), "https://192.168.1.5:8443"; before the sockets
  /// serve.
  void set_addresses(std::vector<std::string> urls) { addresses_.urls = std::move(urls); }
  const std::string& authority_fingerprint() const { return authority_.fingerprint; }
  Control& control() { return *control_; }
  /// The replay that is done ends soon, and none begins any more: the sockets end.
  void stop_replays() { replays_.stop(); }

 private:
  Application() = default;
  Checked<void> open_store(const Setup& setup);
  Expected<void> open_accounts(const Setup& setup);
  void create_stream(const Setup& setup);
  Checked<void> create_cell(const Setup& setup);
  Expected<void> create_cores(const Setup& setup);
  Expected<void> create_editing(const Setup& setup);
  Expected<void> reload();
  void name_damaged_documents();
  void create_metrics();
  void count(const std::string& method, const std::string& path, int status);
  Answer counted(const Request& request, const Answer& answer);
  void flush_recordings();
  void before_step();
  Checked<void> add_operator(const OperatorScript& script);
  void log(const std::string& source, const std::string& text, LogLevel level = LogLevel::info);
  ChannelSources channel_sources();
  Resources resources();

  std::optional<DataFolder> folder_;  // held until all that uses it has ended
  // In the order of construction; a core's strand may still call the host while its pool ends.
  display::Screens screens_;
  std::unique_ptr<Pool> stream_pool_;
  std::unique_ptr<Hub> hub_;
  std::unique_ptr<EventLog> log_;
  std::unique_ptr<Displays> displays_;
  std::unique_ptr<CorePublisher> core_publisher_;
  std::unique_ptr<ServicePublisher> service_publisher_;
  std::unique_ptr<Accounts> accounts_;
  std::optional<LocalKey> process_key_;
  std::unique_ptr<AuditLog> audit_;
  Attempts attempts_;
  Tickets tickets_;
  Pairings pairings_;
  std::optional<Gate> gate_;
  std::unique_ptr<Access> access_;
  std::unique_ptr<Control> control_;
  std::unique_ptr<MotionEnd> motion_end_;
  std::unique_ptr<Metrics> metrics_;
  AuthorityCertificate authority_;
  NetworkAddresses addresses_;
  std::unique_ptr<Documents> documents_;
  std::unique_ptr<Backups> backups_;
  std::unique_ptr<Runs> runs_;
  std::unique_ptr<Samples> samples_;
  std::unique_ptr<Pictures> pictures_;
  std::unique_ptr<JournalWriter> writer_;
  std::unique_ptr<BootList> boot_list_;
  std::unique_ptr<DocumentBreakpoints> breakpoints_;
  std::unique_ptr<Proposals> proposals_;
  std::unique_ptr<Pool> pool_;  // of the cores
  MemoryReturn memory_return_;
  Deadlines deadlines_;
  Worker replays_{deadlines_};
  Pool restores_{1};  // and backups: one at a time; restores wait for cores and edits
  std::unique_ptr<Passwords> passwords_;
  Tasks tasks_;
  IdempotentAnswers answers_;  // outlives the cores: some of what was asked of them may be dropped with them
  std::unique_ptr<Cell> cell_;
  std::unique_ptr<FlowChannels> flows_;
  std::unique_ptr<Cores> cores_;
  std::unique_ptr<CellStop> cell_stop_;
  std::unique_ptr<ManualControl> manual_;
  std::unique_ptr<RunQueue> queue_;
  std::unique_ptr<LiveEdits> live_edits_;
  std::unique_ptr<RunKeeper> keeper_;
  std::unique_ptr<PictureRecorder> picture_recorder_;
  std::unique_ptr<DocumentPublisher> document_publisher_;
  DocumentWatchers document_watchers_;
  std::unique_ptr<Editing> editing_;
  std::unique_ptr<Proposing> proposing_;
  std::unique_ptr<EditQueue> edits_;
  std::unique_ptr<PresenceChannels> presence_;
  std::unique_ptr<Operator> operator_;  // destroyed first, when the cell that calls it has stopped
};

}  // namespace race::server
