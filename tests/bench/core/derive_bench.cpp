// What `race derive` takes on each conformance case, in milliseconds of CPU time: from the texts to the text of the
// derivations, the slowest first. Usage: derive_bench
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "core/execution/derive.h"
#include "core/value/json.h"

namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
  std::ifstream in(path);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

double milliseconds(const std::string& model, const std::string& script) {
  const std::clock_t start = std::clock();
  const auto document = race::execution::derive_texts(model, script);
  const std::string text = race::to_json(document ? *document : race::execution::errors_json(document.error()), 1);
  if (text.empty()) std::puts("");
  return 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

}  // namespace

int main() {
  std::vector<std::pair<double, std::string>> cases;
  for (const auto& folder : fs::directory_iterator(fs::path(RACE_SOURCE_DIR) / "tests" / "conformance")) {
    if (!fs::exists(folder.path() / "script.json")) continue;
    const std::string model = read(folder.path() / "model.json"), script = read(folder.path() / "script.json");
    double best = milliseconds(model, script);
    for (int i = 0; i < 4; ++i) best = std::min(best, milliseconds(model, script));
    cases.emplace_back(best, folder.path().filename().string());
  }
  std::ranges::sort(cases, std::greater());
  std::printf("ms of CPU, best of 5, %zu cases\n", cases.size());
  for (std::size_t i = 0; i < std::min<std::size_t>(8, cases.size()); ++i)
    std::printf("%9.2f  %s\n", cases[i].first, cases[i].second.c_str());
}
