// The cell as it was at the start: first the database, on its thread, then, on the group's, the world with new control
// units. A robot that moves is replaced with its motion: none goes on in the new world.
#include <utility>

#include "server/cell/cell.h"
#include "services/database/database.h"

namespace race::server {

// While it lives and has not ended, no other reset begins: also where who asked for it was told that it is late.
class Cell::Reset {
 public:
  explicit Reset(std::shared_ptr<std::atomic<bool>> under_way) : under_way_(std::move(under_way)) {}
  Reset(const Reset&) = delete;
  ~Reset() { end(); }
  /// Before who asked is answered: the next may begin then.
  void end() {
    if (!std::exchange(ended_, true)) *under_way_ = false;
  }

 private:
  const std::shared_ptr<std::atomic<bool>> under_way_;
  bool ended_ = false;
};

Expected<std::shared_ptr<Cell::Reset>> Cell::begin_reset() {
  if (resetting_->exchange(true))
    return unexpected(ErrorCode::conflict, "the cell is being reset already: wait until that is done");
  return std::make_shared<Reset>(resetting_);
}

void Cell::reset(bool wants_database, Deadlines& deadlines, Done<Value> done) {
  const bool with_database = wants_database && file_.key_of(kDatabaseType);
  if (auto here = check_resettable(with_database); !here) return done(tl::unexpected(std::move(here).error()));
  const auto begun = begin_reset();
  if (!begun) return done(tl::unexpected(begun.error()));
  const auto start = [&](const CellWorld::Wanted& wanted, const CellWorld::Done& executed) {
    const auto reset_rest = [this, executed, reset = *begun] {
      auto result = reset_world();
      reset->end();
      executed(std::move(result));
    };
    if (!with_database) {
      const auto work = [wanted, reset_rest] {
        if (wanted()) reset_rest();
      };
      return queue_.post(work, kPersonLane);
    }
    const auto work = [this, wanted, executed, reset_rest, reset = *begun] {
      if (!wanted()) return;
      if (auto values = database_->reset(start_values_); !values) {
        reset->end();
        return executed(tl::unexpected(std::move(values).error()));
      }
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
  if (robot_host_) {
    ASSIGN_OR_RETURN(auto robot, make_robot());
    host_.replace(*file_.key_of(kRobotType), std::move(robot), kWhy);
  }
  if (gripper_host_) host_.replace(*file_.key_of(kGripperType), make_gripper(), kWhy);
  return local_world_->perform(std::nullopt);
}

}  // namespace race::server
