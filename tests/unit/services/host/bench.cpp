#include "tests/unit/services/host/bench.h"

#include "core/value/json.h"

namespace race::services {

void Bench::changed(const ServiceStatus& status) {
  changes.push_back(status.key + ": " + status.state.value_or("available") + " by " + status.last + ", " +
                    std::to_string(status.pending_count) + " pending");
}

std::vector<std::string> Bench::responses() const {
  std::vector<std::string> all;
  for (const Delivery& delivery : deliveries) {
    if (delivery.kind != Delivery::Kind::response) continue;
    const Value* code = delivery.data.find("code");
    all.push_back(delivery.key + "." + delivery.name +
                  (delivery.is_error ? " !> " + (code ? code->as_string() : "") : " -> " + to_json(delivery.data)));
  }
  return all;
}

}  // namespace race::services
