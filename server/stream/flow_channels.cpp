#include "server/stream/flow_channels.h"

#include <algorithm>
#include <utility>

#include "server/stream/packet_json.h"
#include "server/wire/channel_names.h"
#include "server/wire/path_pattern.h"
#include "services/mutex.h"

namespace race::server {

// What one channel watches. Held by its source and, while it is watched, by the host; by the strand while a packet is
// on its way.
struct FlowChannels::Watch : std::enable_shared_from_this<Watch> {
  Watch(FlowChannels& its_channels, std::string its_key, std::string its_flow)
      : channels(its_channels),
        key(std::move(its_key)),
        flow(std::move(its_flow)),
        name(fill(kFlowChannel, {key, flow})) {}

  /// Under the host's lock: what is not left out waits for the strand, in the place of an older one.
  void came(const services::PacketPtr& packet) {
    {
      const services::MutexLock lock(mutex);
      if (last && packet->time >= *last && packet->time < *last + kPeriod - kTolerance) return;
      last = packet->time;
      if (std::exchange(waiting, packet)) return;
    }
    channels.strand_.post([self = shared_from_this()] { self->publish(); });
  }

  void publish() {
    services::PacketPtr packet;
    {
      const services::MutexLock lock(mutex);
      packet = std::exchange(waiting, nullptr);
    }
    if (packet) channels.hub_.publish_delta(name, packet_json(*packet));
  }

  void end() {
    channels.host_.unwatch(std::exchange(id, 0));
    const services::MutexLock lock(mutex);
    waiting = nullptr;
    last.reset();
  }

  FlowChannels& channels;
  const std::string key, flow, name;
  services::Flows::WatchId id = 0;  // on the hub's strand
  services::Mutex mutex;
  std::optional<services::Time> last GUARDED_BY(mutex);  // of the packets that were not left out
  services::PacketPtr waiting GUARDED_BY(mutex);
};

std::optional<Source> FlowChannels::source(const std::string& key, const std::string& flow) {
  const auto service = host_.service(key);
  if (!service || std::ranges::find(service->publishes, flow, &services::Published::flow) == service->publishes.end())
    return std::nullopt;
  auto watch = std::make_shared<Watch>(*this, key, flow);
  return Source{true, {}, [watch](bool on) {
                  if (!on) return watch->end();
                  auto came = [watch](const services::PacketPtr& packet) { watch->came(packet); };
                  watch->id = watch->channels.host_.watch(watch->key, watch->flow, std::move(came));
                }};
}

}  // namespace race::server
