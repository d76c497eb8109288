#include "server/runs/picture_recorder.h"

#include <future>
#include <utility>

#include "core/value/base64.h"
#include "server/runs/jpeg.h"
#include "server/stream/small_picture.h"
#include "services/encodings.h"

namespace race::server {

PictureRecorder::~PictureRecorder() {
  for (const services::Flows::WatchId watch : watches_) host_.unwatch(watch);
}

void PictureRecorder::connect() {
  for (const services::ServiceStatus& service : host_.services())
    for (const services::Published& published : service.publishes)
      watches_.push_back(
          host_.overhear(service.key, published.flow,
                         [this, key = service.key](const services::PacketPtr& packet) { came(key, packet); }));
}

void PictureRecorder::came(const std::string& service, const services::PacketPtr& packet) {
  if (packet->bytes.empty()) return;
  const Value* encoding = packet->header.find("encoding");
  if (!encoding || *encoding != Value(services::kDepthAndColour)) return;
  {
    const services::MutexLock lock(mutex_);
    const auto [last, is_first] = last_.try_emplace(service, packet->time);
    // Earlier: a world that came back begins anew.
    if (!is_first && packet->time >= last->second && packet->time < last->second + kInterval) return;
    if (waiting_ >= kMostWaiting) return;
    last->second = packet->time;
  }
  ++waiting_;
  strand_.post([this, service, packet] {
    take(service, *packet);
    --waiting_;
  });
}

void PictureRecorder::take(const std::string& service, const services::Packet& packet) {
  Picture picture{service, 0, packet.time, {}};
  for (const auto& core : cores_.all()) {
    const Value info = core->info();
    if (info.find("status")->as_string() != "running" || info.find("paused")->as_bool()) continue;
    if (picture.jpeg.empty()) {
      const auto small = small_picture(packet);
      const auto bytes = small ? jpeg(small->colour, small->width, small->height) : std::nullopt;
      if (!bytes) return;
      picture.jpeg = base64(*bytes);
      if (picture.jpeg.size() > Pictures::kLongest) return;
    }
    picture.step = static_cast<std::uint64_t>(info.find("step")->as_integer());
    const auto stored = pictures_.append(core->run_id(), {picture});
    if (!stored && !failing_) log_(LogLevel::error, to_string(stored.error()));
    failing_ = !stored;
  }
}

void PictureRecorder::flush() {
  std::promise<void> written;
  strand_.post([&] { written.set_value(); });
  written.get_future().wait();
}

}  // namespace race::server
