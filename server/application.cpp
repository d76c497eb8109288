#include "server/application.h"

#include <filesystem>

#include "server/cell/screen_services.h"
#include "server/service_json.h"

namespace race::server {

Checked<std::unique_ptr<Application>> Application::create(const Setup& setup) {
  const auto fail = [](Error error) { return tl::unexpected(std::vector<Error>{std::move(error)}); };
  const std::filesystem::path data(setup.data);
  std::unique_ptr<Application> app(new Application());
  auto documents = Documents::open(data / "documents.sqlite");
  if (!documents) return fail(std::move(documents).error());
  app->documents_ = std::move(*documents);
  if (!setup.demo.empty())
    if (auto put = app->documents_->put_demo(setup.demo); !put) return tl::unexpected(std::move(put).error());
  app->stream_pool_ = std::make_unique<Pool>(1);
  app->hub_ = std::make_unique<Hub>(*app->stream_pool_, setup.first_sequence,
                                    [self = app.get()](const std::string& name) { return self->find_channel(name); });
  app->displays_ = std::make_unique<Displays>(app->screens_, *app->hub_);
  std::vector<ExtraService> extra_services = screen_services(app->screens_, setup.demo);
  extra_services.insert(extra_services.end(), setup.extra_services.begin(), setup.extra_services.end());
  CellSetup cell_setup{setup.demo, data / "database.sqlite", true, std::move(extra_services)};
  cell_setup.remote = setup.remote;
  cell_setup.heartbeat = setup.heartbeat;
  auto cell = Cell::create(cell_setup, *app);
  if (!cell) return fail(std::move(cell).error());
  app->cell_ = std::move(*cell);
  app->flows_ = std::make_unique<FlowChannels>(app->cell_->host(), *app->hub_, *app->stream_pool_);
  app->pool_ = std::make_unique<Pool>(2);
  app->cores_ = std::make_unique<Cores>(*app->pool_, app->cell_->host(), *app);
  if (CellWorld* world = app->cell_->world())
    world->on_pose([self = app.get()](Value pose) { self->hub_->publish_delta("cell/pose", std::move(pose)); });
  if (setup.script)
    if (auto added = app->add_operator(*setup.script); !added) return tl::unexpected(std::move(added).error());
  app->cell_->start_real_time();
  return app;
}

Checked<void> Application::add_operator(const OperatorScript& script) {
  CellWorld* world = cell_->world();
  if (!world)
    return tl::unexpected(std::vector<Error>{{ErrorCode::not_found, "an operator script needs a cell with a world"}});
  if (auto errors = check_bodies(script, *world); !errors.empty()) return tl::unexpected(std::move(errors));
  operator_ = std::make_unique<Operator>(script, screens_, [this](const std::string& text) { log("operator", text); });
  cell_->before_step([this, world] { operator_->step(cell_->clock().now(), *world); });
  return {};
}

Application::~Application() {
  if (cores_) cores_->close();
  if (cell_) cell_->stop();
  pool_.reset();
  stream_pool_.reset();
}

std::optional<Source> Application::find_channel(const std::string& name) {
  if (name == "cores") return Source{false, [this] { hub_->publish_snapshot("cores", cores_json()); }, {}};
  if (name == "services") return Source{false, [this] { hub_->publish_snapshot("services", services_json()); }, {}};
  if (name == "log") return Source{false, [this] { publish_log(); }, {}};
  if (CellWorld* world = cell_->world(); world && name == "cell/pose")
    return Source{true, {}, [world](bool on) { world->watch_pose(on); }};
  if (auto display = displays_->find_channel(name)) return display;
  if (auto flow = flows_->find_channel(name)) return flow;
  constexpr std::string_view kCore = "core/";
  const auto slash = name.rfind('/');
  if (!name.starts_with(kCore) || slash <= kCore.size()) return std::nullopt;
  const auto core = cores_->find(name.substr(kCore.size(), slash - kCore.size()));
  if (!core) return std::nullopt;
  const std::weak_ptr<Core> weak = *core;  // a channel keeps no core
  const auto with = [weak](auto what) {
    return [weak, what](auto... arguments) {
      if (const auto alive = weak.lock()) what(*alive, arguments...);
    };
  };
  const std::string kind = name.substr(slash + 1);
  if (kind == "state") return Source{false, with([](Core& c) { c.watch_state(); }), {}};
  if (kind == "derivation")
    return Source{false, with([](Core& c) { c.watch_derivation(true); }), with([](Core& c, bool on) {
                    if (!on) c.watch_derivation(false);
                  })};
  return std::nullopt;
}

Value Application::services_json() const {
  List list;
  for (const services::ServiceStatus& status : cell_->host().services()) list.push_back(service_json(status));
  Value json = Dict{{"services", std::move(list)}};
  return std::move(json.freeze());
}

Value Application::cores_json() const {
  List list;
  for (const auto& core : cores_->all()) list.push_back(core->info());
  Value json = Dict{{"cores", std::move(list)}};
  return std::move(json.freeze());
}

void Application::core_changed(const std::string& id, Value core) {
  log_status(id, core);
  Value delta = Dict{{"core", std::move(core)}};
  hub_->publish_delta("cores", std::move(delta.freeze()));
}
void Application::core_removed(const std::string& id) {
  {
    const std::lock_guard lock(log_mutex_);
    statuses_.erase(id);
  }
  Value delta = Dict{{"removed", id}};
  hub_->publish_delta("cores", std::move(delta.freeze()));
  hub_->close("core/" + id + "/state");
  hub_->close("core/" + id + "/derivation");
}
void Application::state_snapshot(const std::string& id, Value state) {
  if (operator_) operator_->state(id, state.find("state")->find("active")->as_list());
  hub_->publish_snapshot("core/" + id + "/state", std::move(state));
}
void Application::state_changed(const std::string& id, Value delta) {
  if (operator_) operator_->changed(id, delta.find("active")->as_dict(), delta.find("fired")->as_list());
  hub_->publish_delta("core/" + id + "/state", std::move(delta));
}
void Application::derivation_snapshot(const std::string& id, Value next) {
  hub_->publish_snapshot("core/" + id + "/derivation", std::move(next));
}
void Application::derived(const std::string& id, Value steps) {
  hub_->publish_delta("core/" + id + "/derivation", std::move(steps));
}
void Application::printed(const std::string& id, const std::string& text) { log("core/" + id, text); }

// What becomes of a run is a line of the log: started, ended and how, faulted and where.
void Application::log_status(const std::string& id, const Value& core) {
  const auto text = [](const Value& json, const char* name) {
    const Value* field = json.find(name);
    return field ? field->as_string() : std::string();
  };
  const std::string status = text(core, "status");
  {
    const std::lock_guard lock(log_mutex_);
    std::string& last = statuses_[id];
    if (std::exchange(last, status) == status) return;
  }
  if (operator_ && status == "running") {
    operator_->begin();
    if (const auto core = cores_->find(id)) (*core)->watch_state();
  }
  std::string line = text(core, "document") + ": " + status;
  if (const std::string outcome = text(core, "outcome"); !outcome.empty()) line += " at " + outcome;
  if (const Value* fault = core.find("fault"))
    line += ", " + text(*fault, "kind") + " at " + text(*fault, "at") + ": " + text(*fault, "message");
  log("core/" + id, line);
}

void Application::delivered(const services::Delivery& delivery) {
  if (cores_) cores_->deliver(delivery);
  if (operator_) operator_->happened(delivery);
}

void Application::changed(const services::ServiceStatus& status) {
  Value delta = Dict{{"services", List{service_state_json(status)}}};
  hub_->publish_delta("services", std::move(delta.freeze()));
}

void Application::log(const std::string& source, const std::string& text) {
  logged(cell_->clock().now(), source, text);
}

void Application::logged(services::Time time, const std::string& key, const std::string& text) {
  Value entry = Dict{{"time", time}, {"source", key}, {"text", text.substr(0, kLogText)}};
  entry.freeze();
  {
    const std::lock_guard lock(log_mutex_);
    log_.push_back(entry);
    if (log_.size() > kLogKept) log_.pop_front();
  }
  Value delta = Dict{{"entries", List{entry}}};
  hub_->publish_delta("log", std::move(delta.freeze()));
}

void Application::publish_log() {
  List entries;
  {
    const std::lock_guard lock(log_mutex_);
    entries.assign(log_.begin(), log_.end());
  }
  Value snapshot = Dict{{"entries", std::move(entries)}};
  hub_->publish_snapshot("log", std::move(snapshot.freeze()));
}

}  // namespace race::server
