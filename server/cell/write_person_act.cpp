// Acts as JSON, for the process that does them: what read_person_act() reads, all fields written out.
#include <cmath>

#include "server/cell/person_act.h"

namespace race::server {
namespace {

template <std::size_t N>
Value numbers(const std::array<double, N>& values) {
  return List(values.begin(), values.end());
}

struct Writer {
  Dict operator()(const GrabAct& act) const {
    const world::Hold& hold = act.hold;
    return {{"act", "grab"},
            {"hand", act.hand},
            {"body", hold.body},
            {"point", numbers(hold.point)},
            {"stiffness", hold.stiffness},
            {"damping", hold.damping},
            {"limit", hold.force}};
  }
  Dict operator()(const DragAct& act) const {
    Dict json{{"act", "drag"}, {"hand", act.hand}, {"speed", act.drag.speed}};
    if (act.relative) {
      json.set("by", numbers(act.drag.path.front()));
      return json;
    }
    List path;
    for (const world::Vec3& point : act.drag.path) path.push_back(numbers(point));
    json.set("path", std::move(path));
    return json;
  }
  Dict operator()(const ReleaseAct& act) const { return {{"act", "release"}, {"hand", act.hand}}; }
  Dict operator()(const world::Push& push) const {
    return {{"act", "push"},
            {"body", push.body},
            {"force", numbers(push.force)},
            {"point", numbers(push.point)},
            {"duration", push.duration},
            {"rise", push.rise}};
  }
  Dict operator()(const PlaceAct& act) const {
    Dict json{{"act", "place"}, {"part", act.part}};
    if (const auto& pose = act.o_t_part)
      json.set("pose", Dict{{"position", numbers(pose->position)}, {"orientation", numbers(pose->orientation)}});
    return json;
  }
  Dict operator()(const TakeAct& act) const { return {{"act", "take"}, {"part", act.part}}; }
};

}  // namespace

Value write_person_act(const PersonAct& act) {
  Dict json = std::visit(Writer(), act.what);
  const bool of_a_hand = std::holds_alternative<GrabAct>(act.what) || std::holds_alternative<DragAct>(act.what);
  if (of_a_hand && std::isfinite(act.keep)) json.set("keep", act.keep);
  return json;
}

}  // namespace race::server
