// PictureRecorder: keeps what cameras see while runs are running. It asks no camera for anything: what passes because a
// service or a person looks at it is what the task has seen.
//
// Threads: any, after connect(); pictures are made and written on a thread of its own.
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "server/execution/cores.h"
#include "server/log/line_log.h"
#include "server/store/pictures.h"
#include "server/threads/strand.h"
#include "services/host/host.h"
#include "services/mutex.h"

namespace race::server {

class PictureRecorder {
 public:
  static constexpr services::Time kInterval = 0.5;  // [s] of a camera's time between its pictures
  static constexpr std::size_t kMostWaiting = 4;    // packets, while the disk takes nothing; further ones are left out

  using Log = std::function<void(LogLevel, const std::string&)>;
  /// All outlive it; `log` is called on its thread.
  PictureRecorder(services::Host& host, const Cores& cores, Pictures& pictures, Log log)
      : host_(host), cores_(cores), pictures_(pictures), log_(std::move(log)) {}
  ~PictureRecorder();

  /// To be called once, when all services are there.
  void connect();
  /// Returns when what has come is written. Not on its thread.
  void flush();

 private:
  void came(const std::string& service, const services::PacketPtr& packet) EXCLUDES(mutex_);
  // On its thread.
  void take(const std::string& service, const services::Packet& packet);

  services::Host& host_;
  const Cores& cores_;
  Pictures& pictures_;
  const Log log_;

  std::vector<services::Flows::WatchId> watches_;
  services::Mutex mutex_;
  std::map<std::string, services::Time> last_ GUARDED_BY(mutex_);  // of each service
  std::atomic<std::size_t> waiting_{0};
  bool failing_ = false;  // the last write was; of its thread
  Pool pool_{1, 0, "pictures"};
  Strand strand_{pool_};
};

}  // namespace race::server
