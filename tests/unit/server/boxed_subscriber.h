// A subscriber of the hub that keeps what it gets until a test looks.
#pragma once

#include <optional>
#include <thread>
#include <vector>

#include "core/value/json.h"
#include "server/stream/hub.h"

namespace race::server {

struct BoxedSubscriber : Subscriber {
  Outbox& outbox() override { return box; }
  const Identity& identity() const override { return who; }
  void wake() override {}
  void gather() override {}
  /// The messages that came since.
  std::vector<Value> messages() {
    std::vector<Value> out;
    while (const auto text = box.pop()) out.push_back(parse_json((*text)->json).value());
    return out;
  }
  /// The next message; waits for it.
  Value next() {
    for (;;) {
      if (const auto text = box.pop()) return parse_json((*text)->json).value();
      std::this_thread::yield();
    }
  }
  Outbox box;
  Identity who;
};

}  // namespace race::server
