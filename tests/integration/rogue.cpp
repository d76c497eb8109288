// A server like `race serve` with one more service, `rogue`, which does what its RSM forbids. Prints its port.
#include <cstdio>

#include "core/rsm/document.h"
#include "server/application/application.h"
#include "server/http/listener.h"

namespace {

using namespace race;

const rsm::Service& rogue_model() {
  static const rsm::Service model = rsm::read_service_text(R"json({
    "rsm": 1, "name": "rogue",
    "operations": [{"name": "behave"}, {"name": "jump"}, {"name": "die"}],
    "events": [],
    "states": [{"name": "Calm"}, {"name": "Wild"}], "init": "Calm",
    "transitions": [{"id": "behave", "src": "Calm", "dst": "Calm", "operation": "behave"},
                    {"id": "jump", "src": "Calm", "dst": "Calm", "operation": "jump"},
                    {"id": "die", "src": "Calm", "dst": "Calm", "operation": "die"},
                    {"id": "escape", "src": "Wild", "dst": "Wild"}]})json",
                                                           "services/rogue")
                                        .value();
  return model;
}

class Rogue final : public services::Component {
 public:
  explicit Rogue(services::ServiceHost& host) : host_(host) {}
  const rsm::Service& model() const override { return rogue_model(); }
  void call(const services::Call& call) override {
    if (call.operation == "die") throw std::runtime_error("the rogue has died");
    if (call.operation == "behave") host_.transition("behave", call.id);
    if (call.operation == "jump") host_.transition("escape");  // out of a state that it is not in
    host_.result(call.id, Value(call.operation));              // and of `jump`, without having taken the call
  }

 private:
  services::ServiceHost& host_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  server::Application::Setup setup{argv[1], "", 1, {}};
  setup.extra_services.push_back({"rogue", "rogue", [](auto& host) { return std::make_unique<Rogue>(host); }});
  auto app = server::Application::create(setup);
  if (!app) return 2;
  auto server = server::HttpServer::listen(0, "", (*app)->make_backend());
  if (!server) return 2;
  std::printf("rogue listens on http://127.0.0.1:%u\n", static_cast<unsigned>((*server)->port()));
  std::fflush(stdout);
  (*server)->run();
}
