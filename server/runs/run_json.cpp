#include "server/runs/run_json.h"

#include "services/sqlite/digest.h"

namespace race::server {

Value run_json(const RunRecord& run) {
  Dict json{{"id", std::to_string(run.id)}, {"document", run.document}, {"revision", run.revision}};
  json.set("arguments", run.arguments);
  set_status(run, json);
  if (run.is_over()) json.set("results", run.results.is_null() ? Value(Dict()) : run.results);
  json.set("steps", static_cast<std::int64_t>(run.steps));
  json.set("chain", sqlite::hex(run.chain));
  json.set("created", run.created_ms);
  if (run.ended_ms != 0) json.set("ended", run.ended_ms);
  json.set("imported", run.imported);
  json.set("bytes", static_cast<std::int64_t>(run.bytes));
  return json;
}

void set_status(const RunRecord& run, Dict& json) {
  json.set("status", run.status);
  if (run.status == "ended") json.set("outcome", run.outcome);
  if (run.status == "faulted") json.set("fault", run.fault);
}

Dict picture_json(const Picture& picture) {
  Dict json{{"service", picture.service}, {"step", static_cast<std::int64_t>(picture.step)}, {"time", picture.time}};
  if (!picture.jpeg.empty()) json.set("jpeg", picture.jpeg);
  return json;
}

List samples_json(const std::vector<Sample>& samples) {
  List list;
  for (const Sample& sample : samples)
    list.emplace_back(Dict{{"step", static_cast<std::int64_t>(sample.step)}, {"pose", sample.pose}});
  return list;
}

}  // namespace race::server
