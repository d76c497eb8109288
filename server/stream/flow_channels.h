// FlowChannels: the channels flow/SERVICE/FLOW of the stream: packets of data flows for browsers, a few a second. A
// flow is watched only while its channel has subscribers, so that no picture is rendered for nobody.
//
// Threads: any; packets are made into messages on a strand of the stream's pool, the newest alone if it is slow.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "server/stream/hub.h"
#include "server/threads/strand.h"
#include "services/host/host.h"

namespace race::server {

class FlowChannels {
 public:
  /// In seconds of the packets' time; a little less, as packets have no exact period.
  static constexpr services::Time kPeriod = 0.2, kTolerance = 0.01;

  /// All outlive this, and the host publishes nothing any more when the pool ends.
  FlowChannels(services::Host& host, Hub& hub, Pool& pool) : host_(host), hub_(hub), strand_(pool) {}

  /// The source of a flow's channel; nothing if the service offers no such flow.
  std::optional<Source> source(const std::string& service, const std::string& flow);

 private:
  struct Watch;

  services::Host& host_;
  Hub& hub_;
  Strand strand_;
};

}  // namespace race::server
