// Services of tests/integration/test_cpp_service.py, as a program: those of python_gripper.py. RACE_SOURCE_DIR is the
// project's folder.
#include <atomic>
#include <stdexcept>

#include "race_client/service.h"

namespace {

using race::Value;
using race::client::Call;
using race::client::Failure;
using race::client::Service;

void declare(Service& gripper, std::atomic<int>& halts) {
  gripper.version("1.2");
  gripper.event("moved", "number");
  gripper.operation("move")
      .moves()
      .busy("Moving")
      .parameter("width", "number", {.unit = "m", .min = 0, .max = 0.11})
      .parameter("speed", "number", {.value = 0.1})
      .doc("Moves the fingers.")
      .does([&](Call& call) -> Value {
        const double width = call.number("width");
        if (width == 0.01) throw Failure("jammed", "the fingers are jammed", {{"force", 5.0}});
        for (int step = 0; step < static_cast<int>(width * 1000); ++step) call.pause(0.05);
        gripper.emit("moved", width);
        return call.arguments();
      });
  gripper.operation("stop").safe().stops("Moving").does([&] { ++halts; });
  gripper.operation("count").reads().result("int").does([&] { return halts.load(); });
  gripper.operation("lie").does([&] { gripper.emit("moved", "far"); });
  gripper.operation("fail").does([] { throw std::runtime_error("nothing"); });
  gripper.operation("think").does([&] { return gripper.state(); });
}

}  // namespace

int main(int argc, char** argv) {
  std::atomic<int> halts = 0;
  Service gripper("grip");
  declare(gripper, halts);
  Service timer("patience");
  timer.rsm_file(RACE_SOURCE_DIR "/tests/integration/patience.rsm.json");
  timer.operation("wait").does([](Call& call) {
    call.pause(call.number("seconds"));
    return call.number("seconds");
  });
  timer.operation("begin").does([](Call& call) {
    call.pause(0.05);
    return race::Value("begun");
  });
  return race::client::run(argc, argv, {&gripper, &timer});
}
