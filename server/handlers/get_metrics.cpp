// GET /metrics: for Prometheus. It asks nobody who may take long.
#include "server/handlers/handlers.h"
#include "server/metrics/metrics.h"

namespace race::server {

Handled get_metrics(const Request&, Metrics& metrics) {
  Reply reply;
  reply.text = metrics.text();
  reply.type = Exposition::kType;
  reply.headers.emplace_back("Cache-Control", "no-store");
  return reply;
}

}  // namespace race::server
