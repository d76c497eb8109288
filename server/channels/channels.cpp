#include "server/channels/channels.h"

#include <array>

#include "core/rcm/ids.h"
#include "server/wire/channel_names.h"
#include "server/wire/service_json.h"

namespace race::server {
namespace {

using Sources = ChannelSources;
using MaybeSource = std::optional<Source>;

MaybeSource cores(const Parameters&, const Sources& sources) {
  return Source{false,
                [&hub = sources.hub, &cores = sources.cores] {
                  hub.publish_snapshot(std::string(kCoresChannel), cores_json(cores));
                },
                {}};
}

MaybeSource services(const Parameters&, const Sources& sources) {
  return Source{false,
                [&hub = sources.hub, &host = sources.cell.host()] {
                  hub.publish_snapshot(std::string(kServicesChannel), services_json(host.services()));
                },
                {}};
}

MaybeSource control(const Parameters&, const Sources& sources) {
  return Source{true,
                [&hub = sources.hub, &control = sources.control] {
                  hub.publish_delta(std::string(kControlChannel), control.json());
                },
                {}};
}

MaybeSource log(const Parameters&, const Sources& sources) {
  return Source{false, [&log = sources.log] { log.publish_snapshot(); }, {}};
}

MaybeSource cell_pose(const Parameters&, const Sources& sources) {
  CellWorld* world = sources.cell.world();
  if (!world) return std::nullopt;
  return Source{true, {}, [world](bool on) { world->watch_pose(on); }};
}

MaybeSource display(const Parameters& parameters, const Sources& sources) {
  return sources.displays.source(parameters.at("name"));
}

MaybeSource flow(const Parameters& parameters, const Sources& sources) {
  return sources.flows.source(parameters.at("service"), parameters.at("flow"));
}

// Whether there is a document of this name is known when it has been read.
MaybeSource document(const Parameters& parameters, const Sources& sources) {
  const std::string& name = parameters.at("name");
  if (!rcm::is_id(name)) return std::nullopt;
  return Source{false, [name, &edits = sources.edits] { edits.request_snapshot(name); }, {}};
}

MaybeSource presence(const Parameters& parameters, const Sources& sources) {
  const std::string& name = parameters.at("name");
  if (!rcm::is_id(name)) return std::nullopt;
  return Source{false, [name, &presence = sources.presence] { presence.publish_snapshot(name); }, {}};
}

MaybeSource proposals(const Parameters&, const Sources& sources) {
  return Source{false, [&proposing = sources.proposing] { proposing.publish_snapshot(); }, {}};
}

// Calls `function` with the core that has the id now: it is another one once a model or arguments are loaded into it.
template <typename F>
auto on_core(const Cores& cores, const std::string& id, F function) {
  return [&cores, id, function](auto... arguments) {
    if (const auto core = cores.find(id)) function(**core, arguments...);
  };
}

MaybeSource core_state(const Parameters& parameters, const Sources& sources) {
  const std::string& id = parameters.at("id");
  if (!sources.cores.find(id)) return std::nullopt;
  return Source{false, on_core(sources.cores, id, [](Core& core) { core.watch_state(); }), {}};
}

MaybeSource core_derivation(const Parameters& parameters, const Sources& sources) {
  const std::string& id = parameters.at("id");
  if (!sources.cores.find(id)) return std::nullopt;
  return Source{false, on_core(sources.cores, id, [](Core& core) { core.watch_derivation(true); }),
                on_core(sources.cores, id, [](Core& core, bool on) {
                  if (!on) core.watch_derivation(false);
                })};
}

constexpr std::array kChannels = {
    ChannelKind{kCoresChannel, cores},
    ChannelKind{kServicesChannel, services},
    ChannelKind{kControlChannel, control},
    ChannelKind{kLogChannel, log},
    ChannelKind{kCellPoseChannel, cell_pose},
    ChannelKind{kDisplayChannel, display},
    ChannelKind{kFlowChannel, flow},
    ChannelKind{kDocumentChannel, document},
    ChannelKind{kPresenceChannel, presence},
    ChannelKind{kProposalsChannel, proposals},
    ChannelKind{kCoreStateChannel, core_state},
    ChannelKind{kCoreDerivationChannel, core_derivation},
};

}  // namespace

std::span<const ChannelKind> channels() { return kChannels; }

std::optional<Source> find_channel(std::string_view name, const ChannelSources& sources) {
  for (const ChannelKind& channel : kChannels)
    if (const auto parameters = match(channel.pattern, name)) return channel.source(*parameters, sources);
  return std::nullopt;
}

}  // namespace race::server
