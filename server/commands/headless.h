// Headless: one task with services of its own and no clients, on one thread. World time waits for the core: it passes
// only while nothing is left to do, so the same model, arguments and cell give the same run.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/execution/execution.h"
#include "server/cell/cell.h"
#include "server/cell/operator.h"
#include "server/commands/file_errors.h"

namespace race::server {

struct HeadlessSetup {
  std::string model_file, script_file;        // where document and script are from, for errors
  CellSetup cell;                             // on one thread, whatever it says
  bool fast = false;                          // as fast as possible; else paced by real time
  double limit_s = 3600;                      // of world time; a run that goes on then is left as it is
  std::optional<OperatorScript> script = {};  // who stands at the cell; begins with the run
  display::Screens* screens = nullptr;        // that the script answers; there if it is, and outlives the run
  // Sees the run after each input and after each micro step, which are parts of macro steps then; none: nobody looks.
  std::function<void(const execution::Execution&)> look = {};
};

class Headless final : public services::HostObserver {
 public:
  /// Of a macro step or a service: schemas/core_delta.json without `core` and with `time`, or a line of the log.
  using Report = std::function<void(const Dict&)>;

  /// Runs `document` to its end. The last report has `status`, `outcome` or `fault`, `results`, `time` [s], `steps`
  /// and, if there is a world, `cell`: where everything is then (schemas/cell_pose.json).
  /// Errors: those of the document and of the script, by their files; those of the arguments and the cell.
  static tl::expected<semantics::Status, FileErrors> run(const rcm::Document& document, Dict arguments,
                                                         const HeadlessSetup& setup, const Report& report);

  void delivered(const services::Delivery& delivery) override;
  void changed(const services::ServiceStatus&) override {}
  void logged(services::Time time, const std::string& key, const std::string& text) override;

 private:
  explicit Headless(const Report& report, const HeadlessSetup& setup) : report_(report), look_(setup.look) {}
  void execute(execution::Execution& execution, Cell& cell, const HeadlessSetup& setup);
  void settle(execution::Execution& execution, Cell& cell);
  void take_deliveries(execution::Execution& execution);
  std::uint32_t first_part() const { return look_ ? 0 : execution::Execution::kNoLimit; }
  void finish_step(execution::Execution& execution, const execution::Progress& first, Cell& cell);
  void complete(const execution::Execution& execution, const execution::Progress& progress, Cell& cell);

  const Report& report_;
  const std::function<void(const execution::Execution&)>& look_;
  std::vector<services::Delivery> deliveries_;
  std::unique_ptr<Operator> operator_;
};

}  // namespace race::server
