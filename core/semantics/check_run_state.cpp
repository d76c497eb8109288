// What contradicts itself in a checkpoint: flags and stamps that no sequence of inputs leads to, as far as the rules
// below rely on it or a reader should know.
#include "core/semantics/run_checkpoint_internal.h"
#include "core/value/error_list.h"

namespace race::semantics {
namespace {

class StateCheck {
 public:
  StateCheck(const Program& program, const RunState& run, std::string path, std::vector<Error>& errors)
      : p_(program), r_(run), path_(std::move(path)), errors_(errors) {}

  void check(Status status) {
    for (std::uint32_t s = 0; s < p_.states.size(); ++s) check_state(StateId{s});
    for (std::uint32_t p = 0; p < p_.ports.size(); ++p) check_port(PortId{p});
    for (std::uint32_t b = 0; b < p_.barriers.size(); ++b)
      if (is_on(p_.flag(BarrierId{b})) && !is_on(p_.flag(p_.barriers[b].parent)))
        conflict(p_.barriers[b].path, "an active barrier is in an active state");
    check_root(status);
  }

 private:
  bool is_on(Flag flag) const { return r_.flags[flag] != 0; }
  void conflict(const std::string& at, std::string message) {
    add_error(errors_, {ErrorCode::conflict, std::move(message), path_ + "/states/" + at});
  }

  void check_root(Status status) {
    const StateInfo& root = p_[Program::root];
    const bool active = is_on(p_.flag(Program::root));
    if ((status == Status::running && !active) || (status == Status::ended && active))
      conflict(root.path, "the root is active while the run is running, and inactive when it has ended");
    bool left = false;
    for (const PortId p : root.ports) left = left || is_on(p_.flag(p));
    if (status == Status::ended && !left) conflict(root.path, "a run ends by a port of the root");
  }

  void check_state(StateId s) {
    const StateInfo& info = p_[s];
    const Live& live = r_.live[index(s)];
    const bool is_root = info.parent == kNoState;
    if (is_on(p_.flag(s)) && !is_root && !is_on(p_.flag(info.parent)))
      conflict(info.path, "an active state is in an active state");
    if (is_on(p_.flag(s)) && live.activations == 0) conflict(info.path, "an active state has been activated");
    if (live.life > live.activations) conflict(info.path, "`life` is the number of an activation");
    if (live.left_through == kNoPort && live.left_during == 0) return;
    if (live.left_through == kNoPort && !info.keeps_deep)
      conflict(info.path, "`left_during` needs `left_through`, if `keep` is not `deep`");
    else if (is_root || !info.keeps || live.left_during == 0 || live.left_during > r_.live[index(info.parent)].life)
      conflict(info.path, "`left_through` is of a state with `keep`, in a life of its parent");
  }

  void check_port(PortId p) {
    const PortInfo& info = p_[p];
    const StateInfo& state = p_[info.state];
    const bool parent_active = state.parent == kNoState || is_on(p_.flag(state.parent));
    if (is_on(p_.flag(p)) && (is_on(p_.flag(info.state)) || !parent_active))
      conflict(state.path, "an active port is of an inactive state in an active one");
    if (r_.arrived[index(p)] && (!info.to.barrier || !parent_active))
      conflict(state.path, "a port arrives at a barrier, in an active state");
    if (r_.triggered[index(p)] != 0 && !info.svc) conflict(state.path, "`triggered` is of a port that reads svc");
  }

  const Program& p_;
  const RunState& r_;
  std::string path_;
  std::vector<Error>& errors_;
};

}  // namespace

void check_run_state(const Program& program, const RunState& run, Status status, const std::string& path,
                     std::vector<Error>& errors) {
  StateCheck(program, run, path, errors).check(status);
}

}  // namespace race::semantics
