// OwnServices: services that processes bring of themselves: no group of the server has them, and nothing but their
// hello says what they are. A service stays known by its key when its process has gone, `unavailable` as any that is
// lost, and may come back with another type and RSM.
//
// Threads: read() and add() as it says, host() on that of their group.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/rcm/after.h"
#include "core/rsm/model.h"
#include "core/value/expected.h"
#include "core/value/value.h"
#include "services/host/host.h"
#include "services/host/work_queue.h"
#include "services/remote/remote_component.h"

namespace race::remote {

/// The group of an account that may bring services of its own (and the one that they all are in).
inline constexpr std::string_view kOwnGroup = "own";

/// A service as its process offers it.
struct Offer {
  std::string key, type;
  std::shared_ptr<const rsm::Service> model;
};

/// Error `not_found`, with the key: it is that of a service which no process may bring.
tl::unexpected<Error> not_awaited(const std::string& key);

class OwnServices {
 public:
  static constexpr std::size_t kMost = 32;  // keys, since the server began
  static constexpr std::size_t kKeyBytes = 64;
  /// Others find these by their keys: recognition its pictures, time-outs of ports their ticks.
  static constexpr std::array<std::string_view, 2> kReserved = {"camera", rcm::kTimer};
  static constexpr std::size_t kRsmBytes = 64 * 1024;  // of JSON: everyone who watches services gets all of them

  /// Both outlive it. `queue`: of the group.
  OwnServices(services::Host& host, services::WorkQueue& queue) : host_(host), queue_(queue) {}

  /// What a component of a hello offers; on any thread. Errors, with the key as path: `name`: it or its type is no
  /// name, or too long; `not_found`: the key is one of kReserved; `too_large`: the RSM; `missing`: that has neither an
  /// operation nor an event; those of rsm::read_service().
  static Expected<Offer> read(const std::string& key, const std::string& type, const Value& rsm);
  /// Their keys are known from now on, or nothing has happened. One at a time. Errors: not_awaited(): the host has
  /// another service of this key; `rights`: processes of another account have brought it before, and this one is not of
  /// the server's own user (no account); `too_large`: there are as many as may be.
  Expected<void> add(const std::vector<Offer>& offers, const std::string& account);
  /// The service is declared, or is what is offered from now on; the component that speaks for its process.
  RemoteComponent* host(const Offer& offer);

 private:
  struct Hosted {
    services::ServiceHost* host = nullptr;  // the host's, as the next
    RemoteComponent* component = nullptr;
    Offer offer = {};
  };

  services::Host& host_;
  services::WorkQueue& queue_;
  std::map<std::string, std::string> keys_;  // of add(), with the account that has brought them first
  std::map<std::string, Hosted> hosted_;     // of host()
};

}  // namespace race::remote
