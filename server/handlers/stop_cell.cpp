// POST /api/v1/stop: the cell stops, for everybody who asks. POST /api/v1/stop/reset: motions may begin again, and none
// does. GET /api/v1/control: whether it is stopped, and what runs have reserved.
#include "server/accounts/accounts.h"
#include "server/control/cell_stop.h"
#include "server/handlers/handlers.h"
#include "server/wire/calendar.h"

namespace race::server {

Handled stop_cell(const Request& request, CellStop& cell_stop, Control& control) {
  const bool latches = cell_stop.stop(name_for_people(request.identity), now_ms());
  Reply reply = ok(control.json());
  reply.is_routine = !latches;
  return reply;
}

Handled reset_stop(const Request& request, CellStop& cell_stop, Control& control) {
  const bool resets = cell_stop.reset(name_for_people(request.identity));
  Reply reply = ok(control.json());
  reply.is_routine = !resets;
  return reply;
}

// Who is not known learns that the cell is stopped and where a stop is served, and no names.
Handled get_control(const Request& request, Control& control, Accounts& accounts) {
  const Value all = control.json();
  if (!request.identity.account.empty() || accounts.empty()) return ok(all);
  Dict json{{"stopped", nullptr}, {"mode", *all.find("mode")}, {"holder", nullptr},
            {"request", nullptr}, {"leases", List()},          {"stop_ports", *all.find("stop_ports")}};
  if (const Value& stopped = *all.find("stopped"); !stopped.is_null())
    json.set("stopped", Dict{{"by", "somebody"}, {"time", *stopped.find("time")}});
  if (const Value& holder = *all.find("holder"); !holder.is_null())
    json.set("holder", Dict{{"number", *holder.find("number")}, {"by", "somebody"}});
  return ok(std::move(json));
}

}  // namespace race::server
