// The settings of `race serve`: one table for the options of its command line and the keys of its configuration file
// (config_file.h;
// as JSON api/schemas/server_config.json).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "server/commands/number_range.h"

namespace race::server {

class Arguments;

struct Settings {
  std::string data = "data", demo, web, log_level = "info";
  std::vector<std::string> remote;  // names of component groups
  std::optional<std::string> operator_script;
  double port = 8080, heartbeat_s = 1, keep_runs = 1000, keep_mb = 1024, lan_port = 8443, stop_port = 0,
         lan_stop_port = 0;
  bool headless = false, lan = false;
};

/// A setting: its key is `keep_runs`, its option `--keep-runs`.
struct Setting {
  struct Number {
    double Settings::*value;
    NumberRange range;
  };
  struct Text {
    std::string Settings::*value;
  };
  struct Choice {
    std::string Settings::*value;
    std::span<const std::string_view> words;
  };
  struct Flag {
    bool Settings::*value;
  };
  /// Of a file, which may be the standard input on the command line alone.
  struct File {
    std::optional<std::string> Settings::*value;
  };
  /// Names of component groups, each once: an array; of the option, with commas between them.
  struct Groups {
    std::vector<std::string> Settings::*value;
  };

  std::string key, placeholder, meaning;
  std::variant<Number, Text, Choice, Flag, File, Groups> kind;

  std::string option() const;
};

/// The table, in the order of the options.
std::span<const Setting> settings();

/// Declares all options, which write to `values`; it outlives `arguments`.
void declare_settings(Arguments& arguments, Settings& values);

/// `to` gets the value of a setting from `from`.
void copy_setting(const Setting& setting, const Settings& from, Settings& to);

/// What is wrong in options that parsing does not know: component groups that do not exist or stand twice.
std::vector<Error> check_settings(const Settings& values);

/// Reads a configuration as JSON into `values`. What `arguments` was given as an option stays, but is read and checked
/// all the same. All errors, with the key (`remote/1`) as path: `type`, `unknown_field`, `out_of_range`, `not_found` (a
/// component group), `duplicate`, `not_accepted` (the standard input as a file).
std::vector<Error> read_settings(const Value& json, const Arguments& arguments, Settings& values);

}  // namespace race::server
