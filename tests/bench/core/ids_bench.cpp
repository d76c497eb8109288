// What ids of a large document take (rcm::give_ids), in milliseconds of CPU time, best of 5: of a document without
// ids, of one that has them all, and of one that has lost them, against the revision before. Usage: ids_bench [states]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

#include "core/rcm/ids.h"

namespace {

using race::rcm::Document;

// `count` states in groups of at most a hundred, each with a port and a variable.
Document document_of(int count) {
  Document document;
  document.root.name = "Root";
  for (int made = 1; made < count;) {
    race::rcm::State group;
    group.name = "G" + std::to_string(made++);
    for (int i = 0; i < 99 && made < count; ++i, ++made) {
      race::rcm::State state;
      state.name = "S" + std::to_string(i);
      state.ports.emplace_back().name = "done";
      state.variables.emplace_back().name = "v";
      group.children.emplace_back(std::move(state));
    }
    document.root.children.emplace_back(std::move(group));
  }
  return document;
}

void print_row(const char* what, const Document& before, const Document* previous) {
  double best = 1e300;
  for (int i = 0; i < 5; ++i) {
    Document document = before;
    const std::clock_t start = std::clock();
    race::rcm::give_ids(document, previous);
    best = std::min(best, 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    if (document.root.meta.id.empty()) std::abort();
  }
  std::printf("%-28s %9.1f\n", what, best);
}

}  // namespace

int main(int argc, char** argv) {
  const int states = argc > 1 ? std::max(1, std::atoi(argv[1])) : 100'000;
  const Document without = document_of(states);
  Document with = without;
  race::rcm::give_ids(with);
  std::printf("ms of CPU, %d states\n", states);
  print_row("without ids", without, nullptr);
  print_row("with ids", with, nullptr);
  print_row("lost, against the last", without, &with);
}
