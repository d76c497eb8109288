// Application: everything behind the door of `race serve`: documents, cell, cores, stream, log. Handlers get it, and
// nothing else.
//
// Threads: any.
#pragma once

#include <chrono>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "server/cell/cell.h"
#include "server/cell/operator.h"
#include "server/execution/cores.h"
#include "server/store/documents.h"
#include "server/stream/displays.h"
#include "server/stream/flow_channels.h"
#include "server/stream/hub.h"
#include "services/display/screens.h"

namespace race::server {

/// Of the program and its interface.
inline constexpr std::string_view kVersion = "0.1.0";

class Application final : public CoreWatcher, public services::HostObserver {
 public:
  struct Setup {
    std::string data;  // folder for documents and the database; it exists
    std::string demo;  // folder with scene.json, database.json and *.rcm.json; may be empty
    std::int64_t first_sequence = 1;
    std::vector<ExtraService> extra_services = {};
    std::optional<OperatorScript> script = {};  // begins anew with each run that is started
    std::vector<std::string> remote = {};       // as of CellSetup
    std::chrono::milliseconds heartbeat{1000};  // of their processes
  };
  static Checked<std::unique_ptr<Application>> create(const Setup& setup);
  ~Application() override;

  Documents& documents() { return *documents_; }
  Cell& cell() { return *cell_; }
  Cores& cores() { return *cores_; }
  Hub& hub() { return *hub_; }
  /// The stream's displays, and what they show.
  Displays& displays() { return *displays_; }
  display::Screens& screens() { return screens_; }
  void log(const std::string& source, const std::string& text);

  /// schemas/services.json and schemas/cores.json
  Value services_json() const;
  Value cores_json() const;

  /// A core is gone.
  void core_removed(const std::string& id);

  void core_changed(const std::string& id, Value core) override;
  void state_snapshot(const std::string& id, Value state) override;
  void state_changed(const std::string& id, Value delta) override;
  void derivation_snapshot(const std::string& id, Value next) override;
  void derived(const std::string& id, Value steps) override;
  void printed(const std::string& id, const std::string& text) override;

  void delivered(const services::Delivery& delivery) override;
  void changed(const services::ServiceStatus& status) override;
  void logged(services::Time time, const std::string& key, const std::string& text) override;

 private:
  static constexpr std::size_t kLogKept = 200;
  static constexpr std::size_t kLogText = 2000;  // bytes of a line

  Application() = default;
  std::optional<Source> find_channel(const std::string& name);
  void publish_log();
  Checked<void> add_operator(const OperatorScript& script);
  void log_status(const std::string& id, const Value& core);

  std::mutex log_mutex_;
  std::deque<Value> log_;                        // schemas/log_entry.json
  std::map<std::string, std::string> statuses_;  // of cores, as logged last

  // In the order in which they come to life; a core's strand may still call the host while its pool ends.
  display::Screens screens_;
  std::unique_ptr<Pool> stream_pool_;
  std::unique_ptr<Hub> hub_;
  std::unique_ptr<Displays> displays_;
  std::unique_ptr<Documents> documents_;
  std::unique_ptr<Pool> pool_;  // of the cores
  std::unique_ptr<Cell> cell_;
  std::unique_ptr<FlowChannels> flows_;
  std::unique_ptr<Cores> cores_;
  std::unique_ptr<Operator> operator_;  // fixed after the start; what tells it is still there when the cell has stopped
};

}  // namespace race::server
