// A server like `race serve DATA [DEMO]` with one more service, `rogue`, which does what its RSM forbids. While there
// is a file `hang` in its data folder, whoever asks for its health makes the sockets' thread hang. Prints its port.
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <thread>

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
  if (argc < 2 || argc > 3) return 2;
  server::Application::Setup setup{argv[1], argc > 2 ? argv[2] : "", 1, {}};
  setup.extra_services.push_back({"rogue", "rogue", [](auto& host) { return std::make_unique<Rogue>(host); }});
  auto app = server::Application::create(setup);
  if (!app) return 2;
  server::Backend backend = (*app)->make_backend();
  backend.health = [health = backend.health, hang = std::filesystem::path(argv[1]) / "hang"] {
    while (std::filesystem::exists(hang)) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return health();
  };
  auto server = server::HttpServer::listen(0, "", std::move(backend));
  if (!server) return 2;
  (*app)->control().set_stop_port((*server)->port(), (*server)->stop_port());
  std::printf("rogue listens on http://127.0.0.1:%u\n", static_cast<unsigned>((*server)->port()));
  std::fflush(stdout);
  (*server)->run();
}
