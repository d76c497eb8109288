#include "server/commands/run_test.h"

#include <utility>

#include "core/value/json.h"
#include "server/cell/screen_services.h"
#include "server/commands/headless.h"
#include "server/model_tests/mock.h"
#include "server/model_tests/observed.h"

namespace race::server {
namespace {

// Each mock has chances of its own: what one is asked changes nothing for the others. FNV-1a.
std::uint64_t seed_of(const std::string& key, std::uint64_t seed) {
  std::uint64_t hash = 14695981039346656037ULL ^ seed;
  for (const char c : key) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return hash;
}

void note_end(const Dict& summary, Observed& seen) {
  seen.status = summary.find("status")->as_string();
  seen.time = summary.find("time")->to_double();
  seen.results = summary.find("results")->as_dict();
  if (const Value* outcome = summary.find("outcome")) seen.outcome = outcome->as_string();
  if (const Value* fault = summary.find("fault"))
    seen.fault = fault->find("at")->as_string() + ": " + fault->find("message")->as_string();
}

void note_step(const Dict& step, Observed& seen) {
  const double time = step.find("time")->to_double();
  for (const Value& port : step.find("fired")->as_list()) seen.ports.push_back({time, port.as_string()});
  for (const Value& call : step.find("calls")->as_list())
    seen.calls.push_back({time, call.find("service")->as_string(), call.find("operation")->as_string(),
                          call.find("args")->as_list(), call.find("kwargs")->as_dict()});
}

ExtraService mock_service(const PreparedTest& prepared, const std::string& key, const rsm::Service& model,
                          std::uint64_t seed, std::vector<std::string>& problems) {
  const auto script = prepared.test.services.find(key);
  MockScript of_mock = script == prepared.test.services.end() ? MockScript{} : script->second;
  return {.key = key,
          .type = model.name.empty() ? key : model.name,
          .make = [model, of_mock = std::move(of_mock), seed, &problems](services::ServiceHost& host) {
            return std::make_unique<Mock>(model, of_mock, seed, problems, host);
          }};
}

// What mocks could not do as listed is a reason to fail, whatever else is as expected.
std::vector<Finding> findings_of(const PreparedTest& prepared, const Observed& seen) {
  std::vector<Finding> findings;
  for (const std::string& problem : seen.problems) findings.push_back({prepared.path + "/services", problem});
  for (Finding& each : unmet_expectations(prepared.test.expect, seen, prepared.path))
    findings.push_back(std::move(each));
  return findings;
}

}  // namespace

tl::expected<TestOutcome, FileErrors> run_test(const PreparedTest& prepared, std::uint64_t seed, Coverage& coverage) {
  const ModelTest& test = prepared.test;
  Observed seen;
  CoverageOfRun covered(coverage, *prepared.program, prepared.origin, test.state.value_or(""));
  display::Screens screens;
  HeadlessSetup setup;
  setup.model_file = prepared.model_file;
  setup.cell.folder = prepared.folder;
  setup.cell.database = ":memory:";
  setup.cell.seed = seed;
  setup.fast = true;
  setup.limit_s = test.limit;
  if (test.cell)
    setup.cell.extra_services = screen_services(screens, prepared.folder);
  else
    setup.cell.has_world = false;
  for (const auto& [key, model] : prepared.mocks)
    setup.cell.stand_ins.push_back(mock_service(prepared, key, model, seed_of(key, seed), seen.problems));
  setup.look = [&covered](const execution::Execution& execution) { covered.look(execution); };
  const auto status = Headless::run(prepared.document, test.arguments, setup, [&](const Dict& report) {
    if (report.find("status")) return note_end(report, seen);
    if (report.find("calls")) note_step(report, seen);
  });
  if (!status) return tl::unexpected(status.error());
  for (const FiredPort& each : seen.ports) covered.fired(*prepared.program, each.port);
  return TestOutcome{prepared.file, test.name, seed, seen.time, findings_of(prepared, seen)};
}

}  // namespace race::server
