// What edits of a large model take, in milliseconds of CPU time, best of 5. States have two parameters, a result, a
// variable, an action and two ports each. Then, of models as people write them (task_model.h), one as dense as the
// demonstrator and a heavier one, the median and the 99th percentile of what is computed for one edit before its author
// has the findings. Usage: edit_bench [states]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "core/edit/apply.h"
#include "core/edit/compound.h"
#include "core/edit/history.h"
#include "core/rcm/constraints.h"
#include "core/rcm/document.h"
#include "core/rcm/ids.h"
#include "tests/bench/core/task_model.h"

namespace {

using namespace race;

rcm::State state(const std::string& name, const std::string& next) {
  rcm::State out;
  out.name = name;
  out.parameters.resize(2);
  out.parameters[0].name = "speed";
  out.parameters[0].from = "par.speed";
  out.parameters[1].name = "force";
  out.parameters[1].value = Value(1.5);
  out.results.emplace_back().name = "r";
  out.variables.emplace_back().name = "v";
  out.variables[0].initial = Value(0);
  out.entry = "var.v = par.speed * 2\nsvc.robot.move([par.speed, 0, 1], speed=par.force)";
  out.actions.push_back({"available(svc.robot.pose)", "res.r = svc.robot.pose", {}});
  out.ports.push_back({"done", "svc.robot.move.result and res.r > var.v", {}, next, {}});
  out.ports.push_back({"error", "svc.robot.move.error", {}, {}, {}});
  return out;
}

/// Groups of at most 25 states.
rcm::Document document_of(int count) {
  rcm::Document out;
  out.root = state("Root", "x");
  out.root.parameters[0].from.reset();
  out.root.ports.clear();
  for (int made = 1; made < count;) {
    rcm::State group = state("G" + std::to_string(made++), "x");
    group.ports[0].to.reset();
    for (int i = 0; i < 24 && made < count; ++i, ++made)
      group.children.emplace_back(state("S" + std::to_string(i), "S0"));
    group.first = "S0";
    out.root.children.emplace_back(std::move(group));
  }
  rcm::give_ids(out);
  return out;
}

/// Milliseconds of the processor, and of the clock on the wall.
struct Time {
  double cpu, wall;
};

/// What act(i) takes.
template <typename Act>
Time time_of(int i, Act act) {
  const auto wall = std::chrono::steady_clock::now();
  const std::clock_t cpu = std::clock();
  if (!act(i)) std::abort();
  return {1000.0 * static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC,
          std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - wall).count()};
}

template <typename Act>
void print_row(const char* what, Act act) {
  double best = 1e300;
  for (int i = 0; i < 5; ++i) best = std::min(best, time_of(i, act).cpu);
  std::printf("%-44s %9.2f\n", what, best);
}

template <typename Act>
void print_percentiles(const char* what, Act act) {
  constexpr std::size_t kTimes = 300;
  std::vector<double> cpu, wall;
  for (std::size_t i = 0; i < kTimes; ++i) {
    const Time time = time_of(static_cast<int>(i), act);
    cpu.push_back(time.cpu);
    wall.push_back(time.wall);
  }
  std::printf("%-44s", what);
  for (auto* times : {&cpu, &wall}) {
    std::ranges::sort(*times);
    std::printf(" %9.2f %9.2f", (*times)[kTimes / 2], (*times)[kTimes * 99 / 100]);
  }
  std::printf("\n");
}

/// Of the states that are no links.
edit::Ids ids_of_states(const edit::Tree& tree) {
  edit::Ids out;
  for (std::string& id : tree.subtree(tree.root())) {
    const auto* state = std::get_if<rcm::State>(&tree.find(id)->content);
    if (state && !state->link) out.push_back(std::move(id));
  }
  return out;
}

/// The `i`th of edits as people make them, of a state with ports and actions.
edit::Edit edit_of(const edit::Tree& tree, const std::string& state, int i) {
  const std::string text = std::to_string(i);
  switch (i % 6) {
    case 0:
      return {{edit::Set{state, "doc", {}, Value("As " + text)}}};
    case 1:
      return {{edit::Set{tree.list(state, edit::ListName::ports)[0], "when", {}, Value("par.speed > " + text)}}};
    case 2:
      return {{edit::Set{"", "layout", state, Value(Dict{{"x", i}, {"y", i}})}}};
    case 3:
      return {{edit::Insert{{state, edit::ListName::variables, {}},
                            Dict{{"name", "v" + text}, {"meta", Dict{{"id", "new" + text}}}}}}};
    case 4:  // a violation of structure, until the next edit of this state
      return {{edit::Set{tree.list(state, edit::ListName::ports)[1], "to", {}, Value("Nowhere" + text)}}};
    default:
      return {{edit::Set{tree.list(state, edit::ListName::ports)[1], "to", {}, std::nullopt},
               edit::Set{tree.list(state, edit::ListName::ports)[1], "when", {}, Value("res.unknown == " + text)}}};
  }
}

void measure_findings(int count, bench::Density density) {
  const rcm::Document document = bench::task_document(count, density);
  for (const Error& error : rcm::violations(document)) std::printf("%s\n", to_string(error).c_str());
  edit::History history(edit::Tree::read(document).value());
  const edit::Ids states = ids_of_states(history.tree());
  std::printf("\na task of %zu states with behaviour, %zu elements, %zu bytes of text\n%-44s %19s %19s\n",
              states.size(), history.tree().size(), rcm::format_document(document).size(),
              "ms, median and 99th percentile", "CPU", "wall");
  const auto apply = [&](int i) {
    const std::string& state = states[static_cast<std::size_t>(i / 6 * 31) % states.size()];
    return history.apply("a", history.revision(), edit_of(history.tree(), state, i)).has_value();
  };
  rcm::CodeChecks checks;
  rcm::violations(document, checks);
  const auto findings = [&](const rcm::Document& next) {
    return rcm::violations(next, checks).size() < 1'000'000 && rcm::write_document_text(next).has_value();
  };
  print_percentiles("its document", [&](int) { return !history.tree().document().root.name.empty(); });
  print_percentiles("its violations", [&](int) { return rcm::violations(document).empty(); });
  print_percentiles("its violations, checked before", [&](int) { return rcm::violations(document, checks).empty(); });
  print_percentiles("its text", [&](int) { return rcm::write_document_text(document).has_value(); });
  print_percentiles("an edit, its document, violations and text",
                    [&](int i) { return apply(i) && findings(history.tree().document()); });
}

}  // namespace

int main(int argc, char** argv) {
  const int states = argc > 1 ? std::max(2, std::atoi(argv[1])) : 500;
  const rcm::Document document = document_of(states);
  const edit::Tree tree = edit::Tree::read(document).value();
  std::printf("ms of CPU, %d states, %zu elements, %zu bytes of text\n", states, tree.size(),
              rcm::format_document(document).size());
  const std::string group = tree.list(tree.root(), edit::ListName::children)[0];
  const auto doc = [&](int i) { return edit::Edit{{edit::Set{group, "doc", {}, Value(std::to_string(i))}}}; };
  print_row("a document edited", [&](int i) { return edit::apply(document, doc(i)).has_value(); });
  edit::History history(tree);
  print_row("a history: set", [&](int i) { return history.apply("a", history.revision(), doc(i)).has_value(); });
  print_row("a history: move", [&](int) {
    const edit::Edit move{{edit::Move{group, {tree.root(), edit::ListName::children, {}}}}};
    return history.apply("a", history.revision(), move).has_value();
  });
  print_row("a history: remove", [&](int i) {
    const std::string id = tree.list(group, edit::ListName::children)[static_cast<std::size_t>(i)];
    return history.apply("a", history.revision(), edit::Edit{{edit::Remove{id}}}).has_value();
  });
  print_row("undo", [&](int) { return history.undo("a").has_value(); });
  print_row("the document of a history", [&](int) { return !history.tree().document().root.name.empty(); });
  print_row("its violations", [&](int) { return rcm::violations(document).size() < 1'000'000; });
  print_row("rename of a state", [&](int) { return edit::rename(tree, group, "Another").has_value(); });
  print_row("rename of a parameter of the root", [&](int) {
    return edit::rename(tree, tree.list(tree.root(), edit::ListName::parameters)[0], "another").has_value();
  });
  measure_findings(states, bench::Density::usual);
  measure_findings(states, bench::Density::heavy);
}
