// Arguments: what a command accepts on its command line, bound to the command's variables. Declared once; parsing,
// usage and help come from it (CLI11, in arguments.cpp alone).
//
// Threads: one.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "server/commands/number_range.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace race::server {

class Arguments {
 public:
  /// Of the command `race NAME`.
  explicit Arguments(std::string name);
  ~Arguments();
  Arguments(const Arguments&) = delete;
  Arguments& operator=(const Arguments&) = delete;

  // Declarations: `help` is a line for people, `placeholder` stands for the value. The variables outlive this; options
  // that are absent leave them as they are, which is the default.

  /// One word that must be there.
  void positional(const std::string& name, std::string& value, const std::string& help = "");
  /// One word that may be there.
  void positional(const std::string& name, std::optional<std::string>& value, const std::string& help = "");
  /// All other words; at least one if `required`.
  void positionals(const std::string& name, std::vector<std::string>& values, bool required,
                   const std::string& help = "");
  /// As these and as text(), of files that are read (input.h): `-` is the standard input, in one place of a command
  /// line at most.
  void file(const std::string& name, std::string& path, const std::string& help = "");
  void files(const std::string& name, std::vector<std::string>& paths, const std::string& help = "");
  void file(const std::string& name, const std::string& placeholder, std::optional<std::string>& path,
            const std::string& help);
  void flag(const std::string& name, bool& value, const std::string& help);
  void text(const std::string& name, const std::string& placeholder, std::string& value, const std::string& help);
  void text(const std::string& name, const std::string& placeholder, std::optional<std::string>& value,
            const std::string& help);
  void required_text(const std::string& name, const std::string& placeholder, std::string& value,
                     const std::string& help);
  void number(const std::string& name, const std::string& placeholder, double& value, const NumberRange& range,
              const std::string& help);
  /// One of some words, which outlive this.
  void choice(const std::string& name, const std::string& placeholder, std::string& value,
              std::span<const std::string_view> words, const std::string& help);
  /// Words with commas between them; an empty text is none.
  void names(const std::string& name, const std::string& placeholder, std::vector<std::string>& values,
             const std::string& help);

  /// Words that a shell offers for the value of an argument, as it does those of choice().
  void suggest(const std::string& name, std::vector<std::string> words);

  enum class Outcome : std::uint8_t { parsed, help_requested };
  /// Reads the words after the command's name into the variables. Errors, with the option or the word as path:
  /// `unknown_field` (there is no such option; the message has the one that is probably meant), `syntax` (a word too
  /// many), `missing` (the word, the option or its value), `duplicate` (an option, or `-`), `type` (a value for a
  /// flag), `out_of_range`.
  Expected<Outcome> parse(std::vector<std::string> words);

  /// Whether the words had this option.
  bool given(const std::string& name) const;

  /// "race run MODEL [--fast] [--seed N]"
  std::string usage() const;
  /// An argument that has a help text: "--seed N", and that text, with the default.
  struct Description {
    std::string label, text;
  };
  std::vector<Description> descriptions() const;
  /// A line for each of these.
  std::string help() const;

  /// What the last of some words after the command's name may become, while they are typed.
  struct Place {
    std::string placeholder;              // of the value that it is, such as "FILE"; empty: it is the name of an option
    std::vector<std::string> words = {};  // that may stand there, if these are known
    std::string typed = {};               // of the value
  };
  /// Requires a word, which may be empty.
  Place place_of_last(const std::vector<std::string>& words) const;

 private:
  Error error_of(const std::string& message) const;
  Error misuse() const;
  Expected<void> check_standard_input() const;
  Place place_of(const CLI::Option& argument, std::string typed) const;

  std::unique_ptr<CLI::App> app_;
  std::vector<const CLI::Option*> files_;
  std::map<std::string, std::vector<std::string>> suggestions_;  // by argument
};

/// The JSON object that is the value of an option, such as `--arguments`, which is the path of errors: those of
/// parse_json, and `type`.
Expected<Dict> read_object(const std::string& option, const std::string& text);

}  // namespace race::server
