// Cores: all cores of the server, by id; brings them what services say.
//
// Threads: any.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/rcm/model.h"
#include "server/execution/core.h"
#include "services/mutex.h"

namespace race::server {

class Cores {
 public:
  static constexpr std::size_t kMost = 64;

  /// All outlive this.
  Cores(Pool& pool, services::Host& host, CoreWatcher& watcher) : pool_(pool), host_(host), watcher_(watcher) {}

  /// A core of `document` that waits to be started. Errors: violations of the program (with `type` for a service of
  /// another type than the document expects), an argument that does not fit, `conflict`: there are kMost cores already.
  Checked<std::shared_ptr<Core>> create(const std::string& name, const rcm::Document& document, Dict arguments);
  /// `not_found`: there is none of this id.
  Expected<std::shared_ptr<Core>> find(const std::string& id) const;
  /// In order of creation.
  std::vector<std::shared_ptr<Core>> all() const;
  /// Removes a core, stops its run and reports the removal; waits for the core. Error `not_found`.
  Expected<std::shared_ptr<Core>> remove(const std::string& id);

  /// An event goes to every core that names it, a response to the core whose call it answers.
  void deliver(const services::Delivery& delivery);
  /// No core goes on: the server ends.
  void close();

 private:
  Expected<std::shared_ptr<Core>> take(const std::string& id);

  Pool& pool_;
  services::Host& host_;
  CoreWatcher& watcher_;
  mutable services::Mutex mutex_;
  std::map<std::uint64_t, std::shared_ptr<Core>> cores_ GUARDED_BY(mutex_);
  std::uint64_t next_ GUARDED_BY(mutex_) = 1;
};

/// schemas/cores.json, frozen.
Value cores_json(const Cores& cores);

/// schemas/native.json of a document, frozen.
Checked<Value> native_json(const rcm::Document& document);

}  // namespace race::server
