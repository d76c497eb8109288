// A gripper of your own, 1 mm in 10 ms: replace what `move` does by what your device needs.
#include <atomic>
#include <cmath>

#include "race_client/service.h"

int main(int argc, char** argv) {
  constexpr double kStroke = 0.11;      // [m] between the fingers
  std::atomic<double> width = kStroke;  // `move` has a thread of its own
  race::client::Service gripper("my_gripper");
  gripper.event("moved", "number");
  gripper.operation("move")
      .moves()
      .busy("Moving")
      .parameter("width", "number", {.unit = "m", .min = 0, .max = kStroke})
      .does([&](race::client::Call& call) {
        const double to = call.number("width");
        while (std::abs(to - width) > 0.0005) {
          call.pause(0.01);  // ends here if `stop` was called, or the server is lost
          width = std::round(1000 * width + (to > width ? 1 : -1)) / 1000;
        }
        gripper.emit("moved", width.load());
        return race::Dict{{"width", to}};
      });
  gripper.operation("stop").safe().stops("Moving").doc("The fingers stay where they are.").does([] {});
  const auto state = race::client::types::record({{"width", "number"}});
  gripper.operation("get").reads().result(state).does([&] { return race::Dict{{"width", width.load()}}; });
  return gripper.run(argc, argv);
}
