// The documents of tests/conformance, and small helpers; for tests.
#pragma once

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "core/value/expected.h"
#include "core/value/json.h"

namespace race::rcm {

inline std::string read_text(const std::filesystem::path& file) {
  std::ostringstream out;
  out << std::ifstream(file).rdbuf();
  return out.str();
}

/// The folders of the cases, sorted; those of rejected documents, or the others.
inline std::vector<std::filesystem::path> cases(bool rejected) {
  std::vector<std::filesystem::path> out;
  for (const auto& entry : std::filesystem::directory_iterator(RACE_SOURCE_DIR "/tests/conformance")) {
    if (entry.is_directory() && entry.path().filename().string().starts_with("errors-") == rejected)
      out.push_back(entry.path());
  }
  std::sort(out.begin(), out.end());
  return out;
}

/// Violations as `path: code`, each once.
inline std::set<std::string> pairs(const std::vector<Error>& errors) {
  std::set<std::string> out;
  for (const Error& error : errors) out.insert(error.path + ": " + std::string(name(error.code)));
  return out;
}

}  // namespace race::rcm
