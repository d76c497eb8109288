#include "server/channels/service_publisher.h"

#include <utility>

#include "server/wire/channel_names.h"
#include "server/wire/service_json.h"

namespace race::server {

void ServicePublisher::delivered(const services::Delivery& delivery) {
  if (manual_) manual_->delivered(delivery);
  if (cores_) cores_->deliver(delivery);
  if (operator_) operator_->happened(delivery);
}

void ServicePublisher::changed(const services::ServiceStatus& status) {
  Value delta = Dict{{"services", List{service_state_json(status)}}};
  hub_.publish_delta(std::string(kServicesChannel), std::move(delta.freeze()));
  if (cores_) cores_->service_changed(status.key, status.available ? status.state : std::nullopt);
}

// Changes say nothing of RSMs: the channel begins anew, with all of them.
void ServicePublisher::redescribed() { hub_.restart(std::string(kServicesChannel)); }

void ServicePublisher::logged(services::Time time, const std::string& key, const std::string& text) {
  log_.append(time, key, text);
}

}  // namespace race::server
