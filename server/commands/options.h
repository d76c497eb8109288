// The words of a command line: `--name value`, `--flag` and the rest.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/value/expected.h"

namespace race::server {

struct Options {
  std::map<std::string, std::string, std::less<>> values;  // of options; empty for flags
  std::vector<std::string> rest;

  bool has(std::string_view name) const { return values.contains(name); }
  std::string text(std::string_view name, std::string fallback = "") const;
  /// Error `out_of_range`: not a number, or outside of low .. high.
  Expected<double> number(std::string_view name, double fallback, double low, double high) const;
};

/// `arguments` says which options there are, as a command's usage: "FILE [--port N] [--fast]". Errors, with the option
/// as path: `unknown_field`, `missing` (no value), `duplicate`.
Expected<Options> read_options(const std::vector<std::string>& words, std::string_view arguments);

}  // namespace race::server
