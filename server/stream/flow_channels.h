// FlowChannels: the channels flow/SERVICE/FLOW of the stream: packets of data flows for browsers, a few in a second. A
// flow is watched while somebody listens to its channel, so nobody's picture is drawn for nobody.
//
// Threads: any; packets are made into messages on a strand of the stream's pool, the newest alone if it is slow.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "server/execution/strand.h"
#include "server/stream/hub.h"
#include "services/host/host.h"

namespace race::server {

class FlowChannels {
 public:
  /// In seconds of the packets' time; a little less, as packets have no exact period.
  static constexpr services::Time kPeriod = 0.2, kTolerance = 0.01;

  /// All outlive this, and the host publishes nothing any more when the pool ends.
  FlowChannels(services::Host& host, Hub& hub, Pool& pool) : host_(host), hub_(hub), strand_(pool) {}

  /// The channel of a flow that a service offers; nothing for another name.
  std::optional<Source> find_channel(const std::string& name);

 private:
  struct Watch;

  services::Host& host_;
  Hub& hub_;
  Strand strand_;
};

}  // namespace race::server
