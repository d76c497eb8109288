// Acts as JSON, for the process that does them: what read_person_command() reads, all fields written out.
#include <cmath>

#include "server/cell/person_command.h"

namespace race::server {
namespace {

template <std::size_t N>
Value list_of(const std::array<double, N>& values) {
  return List(values.begin(), values.end());
}

struct Writer {
  Dict operator()(const GrabCommand& command) const {
    const world::Hold& hold = command.hold;
    return {{"act", "grab"},
            {"hand", command.hand},
            {"body", hold.body},
            {"point", list_of(hold.point)},
            {"stiffness", hold.stiffness},
            {"damping", hold.damping},
            {"limit", hold.force}};
  }
  Dict operator()(const DragCommand& command) const {
    Dict json{{"act", "drag"}, {"hand", command.hand}, {"speed", command.drag.speed}};
    if (command.relative) {
      json.set("by", list_of(command.drag.path.front()));
      return json;
    }
    List path;
    for (const world::Vec3& point : command.drag.path) path.push_back(list_of(point));
    json.set("path", std::move(path));
    return json;
  }
  Dict operator()(const ReleaseCommand& command) const { return {{"act", "release"}, {"hand", command.hand}}; }
  Dict operator()(const world::Push& push) const {
    return {{"act", "push"},
            {"body", push.body},
            {"force", list_of(push.force)},
            {"point", list_of(push.point)},
            {"duration", push.duration},
            {"rise", push.rise}};
  }
  Dict operator()(const PlaceCommand& command) const {
    Dict json{{"act", "place"}, {"part", command.part}};
    if (const auto& pose = command.o_t_part)
      json.set("pose", Dict{{"position", list_of(pose->position)}, {"orientation", list_of(pose->orientation)}});
    return json;
  }
  Dict operator()(const TakeCommand& command) const { return {{"act", "take"}, {"part", command.part}}; }
};

}  // namespace

Value write_person_command(const PersonCommand& command) {
  Dict json = std::visit(Writer(), command.what);
  const bool of_a_hand =
      std::holds_alternative<GrabCommand>(command.what) || std::holds_alternative<DragCommand>(command.what);
  if (of_a_hand && std::isfinite(command.keep)) json.set("keep", command.keep);
  return json;
}

}  // namespace race::server
