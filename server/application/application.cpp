#include "server/application/application.h"

#include <algorithm>
#include <thread>

#include "server/application/boot.h"
#include "server/application/collect_metrics.h"
#include "server/cell/component_groups.h"
#include "server/cell/screen_services.h"
#include "server/wire/calendar.h"
#include "server/wire/channel_names.h"
#include "services/failures.h"
#include "services/time_slice.h"

namespace race::server {
namespace {

constexpr unsigned kCoreThreads = 4;  // of cores that have little to do, and of commands to all
constexpr unsigned kMostBusyThreads = 8;

// Of cores that are always busy: they leave a processor to all else.
unsigned busy_core_threads() { return std::clamp(std::thread::hardware_concurrency(), 2U, kMostBusyThreads + 1) - 1; }

tl::unexpected<std::vector<Error>> one(Error error) { return tl::unexpected(std::vector<Error>{std::move(error)}); }

/// Names the file where the error names nothing in it.
tl::unexpected<std::vector<Error>> of_store(Error error, const DataFolder& folder) {
  if (error.path.empty()) error.path = folder.store();
  return one(std::move(error));
}

}  // namespace

Checked<std::unique_ptr<Application>> Application::create(const Setup& setup) {
  std::unique_ptr<Application> app(new Application());
  if (auto opened = app->open_store(setup); !opened) return tl::unexpected(std::move(opened).error());
  app->create_stream(setup);
  if (auto opened = app->open_accounts(setup); !opened) return one(std::move(opened).error());
  if (auto created = app->create_cell(setup); !created) return tl::unexpected(std::move(created).error());
  services::set_failure_handler(
      [raw = app.get()](const std::string& text) { raw->log("server", text, LogLevel::error); });
  if (auto created = app->create_cores(setup); !created) return of_store(std::move(created).error(), *app->folder_);
  app->create_metrics();
  if (auto created = app->create_editing(setup); !created) return of_store(std::move(created).error(), *app->folder_);
  if (setup.script)
    if (auto added = app->add_operator(*setup.script); !added) return tl::unexpected(std::move(added).error());
  app->name_damaged_documents();
  if (const auto& copy = app->folder_->copy_before_upgrade())
    app->log("store", "of an older version of the program; as it was, it is the backup " + *copy);
  app->cell_->start_real_time();
  boot({*app->boot_list_, *app->documents_, *app->runs_, *app->cores_, *app->log_, app->cell_->clock()});
  return app;
}

Checked<void> Application::open_store(const Setup& setup) {
  auto folder = DataFolder::open(setup.data);
  if (!folder) return one(std::move(folder).error());
  folder_.emplace(std::move(*folder));
  auto documents = Documents::open(folder_->store());
  if (!documents) return of_store(std::move(documents).error(), *folder_);
  documents_ = std::move(*documents);
  backups_ = std::make_unique<Backups>(folder_->path(), Backups::Users{.flush = [this] { flush_recordings(); },
                                                                       .restored = [this] { return reload(); }});
  auto runs = Runs::open(folder_->store());
  if (!runs) return of_store(std::move(runs).error(), *folder_);
  runs_ = std::move(*runs);
  auto samples = Samples::open(folder_->store());
  if (!samples) return of_store(std::move(samples).error(), *folder_);
  samples_ = std::move(*samples);
  auto pictures = Pictures::open(folder_->store());
  if (!pictures) return of_store(std::move(pictures).error(), *folder_);
  pictures_ = std::move(*pictures);
  auto writer = JournalWriter::open(folder_->store());
  if (!writer) return of_store(std::move(writer).error(), *folder_);
  writer_ = std::move(*writer);
  auto boot_list = BootList::open(folder_->store());
  if (!boot_list) return of_store(std::move(boot_list).error(), *folder_);
  boot_list_ = std::move(*boot_list);
  auto breakpoints = DocumentBreakpoints::open(folder_->store());
  if (!breakpoints) return of_store(std::move(breakpoints).error(), *folder_);
  breakpoints_ = std::move(*breakpoints);
  auto proposals = Proposals::open(folder_->store());
  if (!proposals) return of_store(std::move(proposals).error(), *folder_);
  proposals_ = std::move(*proposals);
  if (setup.demo.empty()) return {};
  return documents_->put_demo(setup.demo, now_ms());
}

Expected<void> Application::open_accounts(const Setup& setup) {
  const auto named = [](Error error, const std::string& path) {
    if (error.path.empty()) error.path = path;
    return tl::unexpected(std::move(error));
  };
  auto accounts = Accounts::open(folder_->accounts());
  if (!accounts) return named(std::move(accounts).error(), folder_->accounts());
  accounts_ = std::move(*accounts);
  ASSIGN_OR_RETURN(process_key_, LocalKey::open(folder_->process_token(), groups_of_processes()));
  auto audit =
      AuditLog::open(folder_->audit(), [this](const Error& error) { log("audit", to_string(error), LogLevel::error); });
  if (!audit) return named(std::move(audit).error(), folder_->audit());
  audit_ = std::move(*audit);
  passwords_ = std::make_unique<Passwords>(setup.password_cost);
  gate_.emplace(*accounts_, *process_key_, tickets_);
  access_ = std::make_unique<Access>(*gate_, *audit_, pattern_of,
                                     [this](const std::string& text) { log("server", text, LogLevel::warning); });
  return {};
}

void Application::create_stream(const Setup& setup) {
  stream_pool_ = std::make_unique<Pool>(1, 0, "stream");
  stream_pool_->post(services::shorten_time_slice);
  hub_ = std::make_unique<Hub>(*stream_pool_, setup.first_sequence,
                               [this](const std::string& name) { return find_channel(name, channel_sources()); });
  log_ = std::make_unique<EventLog>(*hub_, setup.lines);
  displays_ = std::make_unique<Displays>(screens_, *hub_);
  control_ = std::make_unique<Control>(
      [this](const Value& control) { hub_->publish_delta(std::string(kControlChannel), control); },
      [this] { return has_accounts(); });
  motion_end_ = std::make_unique<MotionEnd>(*control_);
  core_publisher_ = std::make_unique<CorePublisher>(*hub_, *log_);
  service_publisher_ = std::make_unique<ServicePublisher>(*hub_, *log_);
}

Checked<void> Application::create_cell(const Setup& setup) {
  std::vector<ExtraService> extra_services = screen_services(screens_, setup.demo);
  extra_services.insert(extra_services.end(), setup.extra_services.begin(), setup.extra_services.end());
  CellSetup cell_setup{setup.demo, folder_->database(), true, std::move(extra_services)};
  cell_setup.remote = setup.remote;
  cell_setup.heartbeat = setup.heartbeat;
  cell_setup.own_services = true;
  cell_setup.gate = motion_end_.get();
  auto cell = Cell::create(cell_setup, *service_publisher_);
  if (!cell) return tl::unexpected(std::move(cell).error());
  cell_ = std::move(*cell);
  flows_ = std::make_unique<FlowChannels>(cell_->host(), *hub_, *stream_pool_);
  if (CellWorld* world = cell_->world())
    world->on_pose([this, world](Value pose) {
      keeper_->record(pose);
      if (!world->is_pose_watched()) return;
      hub_->publish_delta(std::string(kCellPoseChannel), std::move(pose));
    });
  return {};
}

void Application::flush_recordings() {
  keeper_->flush();
  picture_recorder_->flush();
}

// Damaged runs are named when the cores are made of them.
void Application::name_damaged_documents() {
  const auto heads = documents_->heads();
  if (!heads) return log("store", to_string(heads.error()), LogLevel::error);
  for (const Error& error : heads->damaged) log("store", to_string(error), LogLevel::error);
}

Expected<void> Application::create_cores(const Setup& setup) {
  pool_ = std::make_unique<Pool>(kCoreThreads, busy_core_threads(), "cores");
  cores_ = std::make_unique<Cores>(*pool_, cell_->host(), *core_publisher_, *runs_, *writer_, replays_, deadlines_);
  cell_stop_ =
      std::make_unique<CellStop>(*control_, cell_->host(), *cores_,
                                 CellStop::Marks{StopMark(folder_->stop_mark()), ModeMark(folder_->mode_mark())},
                                 [this](const std::string& text) { log("cell", text, LogLevel::warning); });
  manual_ = std::make_unique<ManualControl>(*control_, cell_->host(), *cell_stop_, deadlines_,
                                            [this](const Identity& identity, std::string action, std::string outcome) {
                                              access_->record(identity, std::move(action), std::move(outcome));
                                            });
  service_publisher_->set_manual_control(*manual_);
  cell_->before_step([this] { before_step(); });
  live_edits_ = std::make_unique<LiveEdits>(*documents_, *cores_);
  document_watchers_.add(*live_edits_);
  keeper_ = std::make_unique<RunKeeper>(*runs_, *samples_, setup.retention,
                                        [this](LogLevel level, const std::string& text) { log("store", text, level); });
  keeper_->connect(*cores_, cell_->world());
  picture_recorder_ =
      std::make_unique<PictureRecorder>(cell_->host(), *cores_, *pictures_,
                                        [this](LogLevel level, const std::string& text) { log("store", text, level); });
  picture_recorder_->connect();
  queue_ = std::make_unique<RunQueue>(*control_, *documents_, *cores_, *access_);
  core_publisher_->on_change([this](const std::string& id, const Value& core) {
    keeper_->core_changed(id, core);
    queue_->core_changed(id, core);
  });
  core_publisher_->connect(cell_->clock(), *cores_);
  service_publisher_->connect(*cores_);
  auto recovered = cores_->recover();
  keeper_->apply_limits();
  return recovered;
}

// The store is that of a backup. What cannot be read of one part of it keeps the other from nothing.
Expected<void> Application::reload() {
  auto proposals = proposing_->reload();
  auto recovered = cores_->recover();
  return proposals ? recovered : proposals;
}

// Who follows documents is added to the watchers.
Expected<void> Application::create_editing(const Setup& setup) {
  document_publisher_ = std::make_unique<DocumentPublisher>(*hub_);
  editing_ = std::make_unique<Editing>(*documents_, *document_publisher_, document_watchers_);
  proposing_ = std::make_unique<Proposing>(*proposals_, *documents_, *editing_, *hub_);
  document_watchers_.add(*proposing_);
  edits_ = std::make_unique<EditQueue>(*editing_, *hub_, *access_);
  presence_ = std::make_unique<PresenceChannels>(*hub_, deadlines_, setup.first_sequence);
  return proposing_->reload();
}

Checked<void> Application::add_operator(const OperatorScript& script) {
  CellWorld* world = cell_->world();
  if (!world) return one({ErrorCode::not_found, "an operator script needs a cell with a world"});
  if (auto errors = check_bodies(script, *world); !errors.empty()) return tl::unexpected(std::move(errors));
  operator_ = std::make_unique<Operator>(script, screens_, [this](const std::string& text) { log("operator", text); });
  core_publisher_->set_operator(*operator_);
  service_publisher_->set_operator(*operator_);
  return {};
}

// Of the cell, on its thread.
void Application::before_step() {
  manual_->check(std::chrono::steady_clock::now());
  if (operator_) operator_->step(cell_->clock().now(), *cell_->world());
}

Application::~Application() {
  services::set_failure_handler({});
  if (motion_end_) motion_end_->finish();
  if (cell_stop_) cell_stop_->end();
  if (queue_) queue_->end();
  if (cores_) cores_->close();
  if (backups_) backups_->stop();
  restores_.drop();
  restores_.end();  // one that is under way waits for the cores
  // What is asked is answered by nobody from here on, and what it would use may go.
  passwords_.reset();
  deadlines_.close();
  replays_.end();
  edits_.reset();
  if (live_edits_) live_edits_->close();
  if (cores_) cores_->close();  // also those that a restore has brought
  if (cell_) cell_->stop();
  if (writer_) writer_->close();  // before the strands that it tells
  if (pool_) pool_->end();
  if (cores_) cores_->end_changes();  // after the strands that post there
  if (stream_pool_) stream_pool_->end();
  if (audit_) audit_->close();  // while what it says is still logged
}

void Application::create_metrics() {
  Metrics::Routes all;
  for (const Route& route : routes()) all.emplace_back(route.method, route.pattern);
  for (const std::string_view path : websocket_paths()) all.emplace_back("GET", path);
  metrics_ = std::make_unique<Metrics>(
      all, [sources = MetricSources{folder_->store(), *hub_, *cores_, *cell_, *control_, *writer_, *audit_, *log_}](
               Exposition& to) { collect_metrics(sources, to); });
}

void Application::count(const std::string& method, const std::string& path, int status) {
  metrics_->answered(method, pattern_of(method, path), status, std::chrono::nanoseconds(0));
}

// An answer that is counted when it is there.
Answer Application::counted(const Request& request, const Answer& answer) {
  const std::string_view pattern = pattern_of(request.method, request.path);
  const auto begin = std::chrono::steady_clock::now();
  return Answer([this, method = request.method, pattern, begin, answer](Reply reply) {
    metrics_->answered(method, pattern, reply.status, std::chrono::steady_clock::now() - begin);
    if (Access::is_login(pattern) && (reply.status == 401 || reply.status == 429)) metrics_->login_failed();
    answer(std::move(reply));
  });
}

Backend Application::make_backend() {
  return {[this](const Request& request) {
            auto admitted = access_->admit(request);
            if (!admitted) count(request.method, request.path, admitted.error().status);
            return admitted;
          },
          [this](Request request, const Answer& answer) {
            const Answer audited = access_->audited(request, counted(request, answer));
            handle(std::move(request), resources(), audited);
          },
          [this] {
            count("GET", "/api/v1/health", 200);
            return *get_health({}, *cell_);
          },
          [this](const Identity& identity) {
            Request request;
            request.identity = identity;
            Reply reply = *stop_cell(request, *cell_stop_, *control_);
            access_->record_stop(identity, reply);
            count("POST", "/api/v1/stop", 200);
            return reply;
          },
          *hub_,
          *displays_,
          *edits_,
          *presence_,
          *manual_,
          *access_,
          cell_->remotes(),
          metrics_->clients(),
          [this](const std::string& why, std::function<void()> done) {
            log("server", "ends: " + why);
            queue_->close();
            motion_end_->begin_end(cell_->host(), *cores_,
                                   [this, done = std::move(done)] { hub_->after(done); });  // when that is told, too
          }};
}

void Application::log(const std::string& source, const std::string& text, LogLevel level) {
  log_->append(cell_->clock().now(), source, text, level);
}

ChannelSources Application::channel_sources() {
  return {*hub_, *cores_, *cell_, *displays_, *flows_, *log_, *edits_, *presence_, *proposing_, *control_};
}

Resources Application::resources() {
  return {*documents_, *breakpoints_, *editing_,  *proposals_,  *proposing_, *boot_list_, *backups_, *runs_,
          *samples_,   *pictures_,    *cores_,    *live_edits_, replays_,    deadlines_,  restores_, *cell_,
          *log_,       answers_,      *accounts_, *passwords_,  attempts_,   tickets_,    *audit_,   authority_,
          *control_,   *cell_stop_,   *metrics_,  *manual_,     pairings_,   addresses_,  *queue_,   tasks_};
}

}  // namespace race::server
