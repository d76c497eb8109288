// The cell as it was at the start: first the database, on its thread, then, on the group's, the world with new control
// units. A robot that moves is replaced with its motion: none goes on in the new world.
#include <utility>

#include "server/cell/cell.h"
#include "services/database/database.h"

namespace race::server {

void Cell::reset(bool with_database, Deadlines& deadlines, Done<Value> done) {
  if (auto here = check_resettable(with_database); !here) return done(tl::unexpected(std::move(here).error()));
  const auto start = [&](const CellWorld::Wanted& wanted, const CellWorld::Done& executed) {
    const auto reset_rest = [this, executed] { executed(reset_world()); };
    if (!with_database) {
      const auto work = [wanted, reset_rest] {
        if (wanted()) reset_rest();
      };
      return queue_.post(work, kPersonLane);
    }
    const auto work = [this, wanted, executed, reset_rest] {
      if (!wanted()) return;
      if (auto reset = database_->reset(start_values_); !reset)
        return executed(tl::unexpected(std::move(reset).error()));
      queue_.post(reset_rest, kPersonLane);
    };
    database_queue().post(work, kPersonLane);
  };
  pending_commands_.start(start, deadlines, std::move(done));
}

Expected<void> Cell::check_resettable(bool with_database) const {
  const auto elsewhere = [](const std::string& what, const std::string& hint) {
    return unexpected(ErrorCode::conflict, "the " + what + " is a process of its own: " + hint);
  };
  if (!local_world_) return elsewhere("cell", "end and start `race service cell`, and it begins anew");
  if (with_database && !database_) return elsewhere("database", "its values stay; reset the cell without them");
  return {};
}

Expected<Value> Cell::reset_world() {
  constexpr const char* kWhy = "the cell was reset";
  local_world_->reset();
  ASSIGN_OR_RETURN(auto robot, make_robot());
  host_.replace("robot", std::move(robot), kWhy);
  host_.replace("gripper", make_gripper(), kWhy);
  return local_world_->perform(std::nullopt);
}

}  // namespace race::server
