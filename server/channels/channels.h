// The table of channels of the stream: which names there are, and where the data of each comes from.
//
// Threads: the hub's strand.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "server/cell/cell.h"
#include "server/control/control.h"
#include "server/editing/edit_queue.h"
#include "server/editing/presence_channels.h"
#include "server/editing/proposing.h"
#include "server/execution/cores.h"
#include "server/log/event_log.h"
#include "server/stream/displays.h"
#include "server/stream/flow_channels.h"
#include "server/stream/hub.h"
#include "server/wire/path_pattern.h"

namespace race::server {

/// What channels take their data from; all outlive the hub's channels.
struct ChannelSources {
  Hub& hub;
  Cores& cores;
  Cell& cell;
  Displays& displays;
  FlowChannels& flows;
  EventLog& log;
  EditQueue& edits;
  PresenceChannels& presence;
  Proposing& proposing;
  Control& control;
};

struct ChannelKind {
  std::string_view pattern;  // "core/{id}/state" (server/wire/channel_names.h)
  /// The source of the channel with these parameters; nothing if there is none now.
  std::optional<Source> (*source)(const Parameters& parameters, const ChannelSources& sources);
};

/// All of them.
std::span<const ChannelKind> channels();

/// The source of the channel of this name; nothing if there is no such channel.
std::optional<Source> find_channel(std::string_view name, const ChannelSources& sources);

}  // namespace race::server
