#include "server/commands/arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>

#include "core/value/json.h"
#include "server/commands/input.h"
#include "server/commands/near_word.h"

namespace race::server {
namespace {

bool is_flag(const CLI::Option& option) { return option.get_items_expected_min() == 0; }

// "--seed N", "--fast", "MODEL", "RSM..."
std::string label(const CLI::Option& option) {
  if (!option.nonpositional()) return option.get_name() + (option.get_expected_max() > 1 ? "..." : "");
  return option.get_name() + (is_flag(option) ? "" : ' ' + option.get_type_name());
}

// In the order of their declaration.
std::vector<const CLI::Option*> arguments_of(const CLI::App& app) {
  return app.get_options([&app](const CLI::Option* option) { return option != app.get_help_ptr(); });
}

// No number (nan) is refused too, and a whole one that is not written as such (8e3, 80.0).
CLI::Validator within(const NumberRange& range) {
  const auto check = [range](const std::string& text) -> std::string {
    double value = 0;
    const char* end = text.data() + text.size();
    const auto format = range.whole ? std::chars_format::fixed : std::chars_format::general;
    const auto read = std::from_chars(text.data(), end, value, format);
    const bool is_written_so = !range.whole || text.find('.') == std::string::npos;
    if (read.ec == std::errc() && read.ptr == end && is_written_so && range.has(value)) return "";
    return "must be " + range.text() + ", got " + quote(text);
  };
  return {check, ""};
}

CLI::Validator one_of(std::span<const std::string_view> words) {
  const auto check = [words](const std::string& text) -> std::string {
    if (std::ranges::find(words, text) != words.end()) return "";
    return "must be one of " + joined(words) + ", got " + quote(text);
  };
  return {check, ""};
}

bool is_option(const std::string& word) { return word.size() > 1 && word.starts_with('-'); }

// `--data=` as `--data` and an empty word: CLI11 would take the next word as its value.
std::vector<std::string> split_empty_values(const CLI::App& app, const std::vector<std::string>& words) {
  std::vector<std::string> split;
  for (const std::string& word : words) {
    const std::string name = word.substr(0, word.size() - 1);
    const CLI::Option* option = word.ends_with('=') && is_option(name) ? app.get_option_no_throw(name) : nullptr;
    if (option && !is_flag(*option))
      split.insert(split.end(), {name, ""});
    else
      split.push_back(word);
  }
  return split;
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names = {"--help"};
  for (const CLI::Option* option : arguments_of(app))
    if (option->nonpositional()) names.push_back(option->get_name());
  return names;
}

}  // namespace

Arguments::Arguments(std::string name) : app_(std::make_unique<CLI::App>("", std::move(name))) {}
Arguments::~Arguments() = default;

void Arguments::positional(const std::string& name, std::string& value, const std::string& help) {
  app_->add_option(name, value, help)->required();
}

void Arguments::positional(const std::string& name, std::optional<std::string>& value, const std::string& help) {
  app_->add_option_function<std::string>(
      name, [&value](const std::string& text) { value = text; }, help);
}

void Arguments::positionals(const std::string& name, std::vector<std::string>& values, bool required,
                            const std::string& help) {
  app_->add_option(name, values, help)->required(required);
}

void Arguments::file(const std::string& name, std::string& path, const std::string& help) {
  positional(name, path, help);
  files_.push_back(app_->get_option(name));
}

void Arguments::files(const std::string& name, std::vector<std::string>& paths, const std::string& help) {
  positionals(name, paths, true, help);
  files_.push_back(app_->get_option(name));
}

void Arguments::file(const std::string& name, const std::string& placeholder, std::optional<std::string>& path,
                     const std::string& help) {
  text(name, placeholder, path, help);
  files_.push_back(app_->get_option(name));
}

void Arguments::flag(const std::string& name, bool& value, const std::string& help) {
  app_->add_flag(name, value, help)->multi_option_policy(CLI::MultiOptionPolicy::Throw)->disable_flag_override();
}

void Arguments::text(const std::string& name, const std::string& placeholder, std::string& value,
                     const std::string& help) {
  app_->add_option(name, value, help)->type_name(placeholder)->capture_default_str();
}

void Arguments::text(const std::string& name, const std::string& placeholder, std::optional<std::string>& value,
                     const std::string& help) {
  app_->add_option_function<std::string>(
          name, [&value](const std::string& text) { value = text; }, help)
      ->type_name(placeholder);
}

void Arguments::required_text(const std::string& name, const std::string& placeholder, std::string& value,
                              const std::string& help) {
  app_->add_option(name, value, help)->type_name(placeholder)->required();
}

void Arguments::number(const std::string& name, const std::string& placeholder, double& value, const NumberRange& range,
                       const std::string& help) {
  app_->add_option(name, value, help)->type_name(placeholder)->capture_default_str()->check(within(range));
}

void Arguments::choice(const std::string& name, const std::string& placeholder, std::string& value,
                       std::span<const std::string_view> words, const std::string& help) {
  app_->add_option(name, value, help)->type_name(placeholder)->capture_default_str()->check(one_of(words));
  suggest(name, {words.begin(), words.end()});
}

void Arguments::names(const std::string& name, const std::string& placeholder, std::vector<std::string>& values,
                      const std::string& help) {
  app_->add_option_function<std::string>(
          name,
          [&values](const std::string& text) {
            values.clear();
            for (std::size_t at = 0; at < text.size();) {
              const std::size_t end = std::min(text.find(',', at), text.size());
              values.push_back(text.substr(at, end - at));
              at = end + 1;
            }
          },
          help)
      ->type_name(placeholder);
}

void Arguments::suggest(const std::string& name, std::vector<std::string> words) {
  suggestions_[name] = std::move(words);
}

bool Arguments::given(const std::string& name) const { return app_->count(name) > 0; }

// CLI11 names the option in its message alone: "--port: ...", or "fast was ..." for a flag with a value.
Error Arguments::error_of(const std::string& message) const {
  std::string name = message.substr(0, message.find_first_of(": "));
  if (!name.starts_with('-')) name.insert(0, "--");
  const CLI::Option* option = app_->get_option_no_throw(name);
  if (!option) return {ErrorCode::type, message, ""};
  if (option->count() > 1) return {ErrorCode::duplicate, "the option stands twice", name};
  if (is_flag(*option)) return {ErrorCode::type, "the option takes no value", name};
  return {ErrorCode::missing, "the option needs a value", name};
}

// Words are too many or too few. A misspelled option comes first: its value may be the word too many.
Error Arguments::misuse() const {
  const auto extra = app_->remaining();
  if (const auto option = std::ranges::find_if(extra, is_option); option != extra.end()) {
    const std::string name = option->substr(0, option->find('='));
    return {ErrorCode::unknown_field, "there is no such option" + suggestion(name, option_names(*app_)), name};
  }
  for (const CLI::Option* argument : arguments_of(*app_))
    if (argument->get_required() && argument->count() == 0)
      return {ErrorCode::missing, "the command needs it", argument->get_name()};
  return {ErrorCode::syntax, "is a word too many", extra.empty() ? "" : extra.front()};
}

Expected<void> Arguments::check_standard_input() const {
  std::ptrdiff_t count = 0;
  for (const CLI::Option* option : files_) {
    count += std::ranges::count(option->results(), kStandardInput);
    if (count > 1)
      return unexpected(ErrorCode::duplicate, "`-` stands twice; the standard input is read once", option->get_name());
  }
  return {};
}

Expected<Arguments::Outcome> Arguments::parse(std::vector<std::string> words) {
  words = split_empty_values(*app_, words);
  std::ranges::reverse(words);  // as CLI11 expects them
  try {
    app_->parse(words);
  } catch (const CLI::CallForHelp&) {
    return Outcome::help_requested;
  } catch (const CLI::ExtrasError&) {
    return tl::unexpected(misuse());
  } catch (const CLI::RequiredError&) {
    return tl::unexpected(misuse());
  } catch (const CLI::ValidationError& failure) {
    const std::string message = failure.what();
    const auto end = message.find(": ");
    return unexpected(ErrorCode::out_of_range, message.substr(end + 2), message.substr(0, end));
  } catch (const CLI::ParseError& failure) {
    return tl::unexpected(error_of(failure.what()));
  }
  if (auto once = check_standard_input(); !once) return tl::unexpected(std::move(once).error());
  return Outcome::parsed;
}

std::string Arguments::usage() const {
  std::string line = "race " + app_->get_name();
  for (const CLI::Option* option : arguments_of(*app_))
    line += option->get_required() ? ' ' + label(*option) : " [" + label(*option) + ']';
  return line;
}

std::vector<Arguments::Description> Arguments::descriptions() const {
  std::vector<Description> all;
  for (const CLI::Option* option : arguments_of(*app_)) {
    if (option->get_description().empty()) continue;
    const std::string fallback = option->get_default_str();
    all.push_back({label(*option),
                   option->get_description() + (fallback.empty() || is_flag(*option) ? "" : " (" + fallback + ')')});
  }
  return all;
}

std::string Arguments::help() const {
  std::size_t width = 0;
  for (const CLI::Option* option : arguments_of(*app_)) width = std::max(width, label(*option).size());
  std::string text;
  for (const Description& each : descriptions())
    text += "  " + each.label + std::string(width - each.label.size() + 3, ' ') + each.text + '\n';
  return text;
}

Arguments::Place Arguments::place_of(const CLI::Option& argument, std::string typed) const {
  const auto found = suggestions_.find(argument.get_name());
  return {argument.nonpositional() ? argument.get_type_name() : argument.get_name(),
          found == suggestions_.end() ? std::vector<std::string>() : found->second, std::move(typed)};
}

Arguments::Place Arguments::place_of_last(const std::vector<std::string>& words) const {
  const std::string& last = words.back();
  std::size_t before = 0;  // positionals
  for (std::size_t at = 0; at + 1 < words.size(); ++at) {
    const CLI::Option* option = is_option(words[at]) ? app_->get_option_no_throw(words[at]) : nullptr;
    const bool takes_next = option && !is_flag(*option);
    if (takes_next && at + 2 == words.size()) return place_of(*option, last);
    if (takes_next)
      ++at;
    else if (!is_option(words[at]))
      ++before;
  }
  if (last.starts_with('-')) {
    const std::size_t end = last.find('=');
    if (end == std::string::npos) return {"", option_names(*app_), last};
    const CLI::Option* option = app_->get_option_no_throw(last.substr(0, end));
    return option && !is_flag(*option) ? place_of(*option, last.substr(end + 1)) : Place{""};
  }
  for (const CLI::Option* argument : arguments_of(*app_)) {
    if (argument->nonpositional()) continue;
    if (before == 0 || argument->get_expected_max() > 1) return place_of(*argument, last);
    --before;
  }
  return {""};
}

Expected<Dict> read_object(const std::string& option, const std::string& text) {
  const auto value = parse_json(text);
  if (!value) return unexpected(value.error().code, value.error().message, option);
  if (!value->is_dict()) return unexpected(ErrorCode::type, "must be an object", option);
  return value->as_dict();
}

}  // namespace race::server
