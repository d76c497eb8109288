// URDF texts, which may come from another process: each is refused with a reason, or becomes a model whose parts are
// what robot_model.h says. urdfdom itself is not instrumented: what it does is seen by the address sanitizer's heap
// alone.
#include <console_bridge/console.h>

#include <cmath>

#include "services/world/robot_model.h"
#include "services/world/urdf_limits.h"
#include "tests/fuzz/support/expect.h"
#include "tests/fuzz/support/input.h"

namespace race::world {
namespace {

bool is_unit(const Vec3& v) { return std::abs(std::hypot(v[0], v[1], v[2]) - 1) < 1e-9; }

void hold(const RobotModel& model) {
  FUZZ_EXPECT(!model.links.empty() && model.links.size() <= kUrdfLinks);
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const Link& link = model.links[i];
    FUZZ_EXPECT(i == 0 ? link.parent == -1 : link.parent >= 0 && link.parent < static_cast<int>(i));
    FUZZ_EXPECT(model.link(link.name) == static_cast<int>(i));
    if (i == 0 || link.joint.kind == Joint::Kind::fixed) continue;
    FUZZ_EXPECT(is_unit(link.joint.axis));
    FUZZ_EXPECT(link.joint.lower < link.joint.upper && link.joint.max_velocity > 0);
    FUZZ_EXPECT(link.mass > 0);
  }
}

}  // namespace
}  // namespace race::world

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  console_bridge::noOutputHandler();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (const auto model = race::world::read_urdf(std::string(race::fuzz::text_of(data, size))))
    race::world::hold(*model);
  return 0;
}
