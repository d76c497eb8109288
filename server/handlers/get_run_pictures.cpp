// GET /api/v1/runs/{run}/pictures: which pictures of cameras there are of the time in which the run was running;
// GET .../pictures/{number}: one of them.
#include "server/handlers/query.h"
#include "server/handlers/runs.h"
#include "server/runs/run_json.h"
#include "server/store/pictures.h"

namespace race::server {

Handled get_run_pictures(const Request& request, Runs& runs, Pictures& pictures) {
  const auto run = run_of(request, runs);
  if (!run) return failed(run.error());
  const auto found = pictures.list(run->id);
  if (!found) return failed(found.error());
  List list;
  for (const NumberedPicture& each : *found) {
    Dict json = picture_json(each.picture);
    json.set("number", each.number);
    list.push_back(std::move(json));
  }
  return ok(Dict{{"pictures", std::move(list)}});
}

Handled get_run_picture(const Request& request, Runs& runs, Pictures& pictures) {
  const auto run = run_of(request, runs);
  if (!run) return failed(run.error());
  // What is no number names no picture.
  const auto picture = pictures.read(run->id, whole_number(request.parameters.at("number")).value_or(-1));
  if (!picture) return failed(picture.error());
  return ok(picture_json(*picture));
}

}  // namespace race::server
