#include "server/commands/config_file.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "core/value/error_list.h"
#include "core/value/json.h"
#include "server/commands/arguments.h"
#include "server/commands/input.h"
#include "server/commands/near_word.h"

namespace race::server {
namespace {

constexpr std::string_view kSpaces = " \t\r";

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(kSpaces);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpaces) - first + 1);
}

bool is_control(char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0 && c != '\t'; }

std::string key_of(const Setting& setting) { return setting.option().substr(2); }

const Setting* find_setting(std::string_view key) {
  const auto found = std::ranges::find_if(settings(), [&](const Setting& each) { return key_of(each) == key; });
  return found == settings().end() ? nullptr : &*found;
}

std::vector<std::string> keys() {
  std::vector<std::string> all;
  for (const Setting& setting : settings()) all.push_back(key_of(setting));
  return all;
}

class Reader {
 public:
  Reader(const std::string& file, const Arguments& arguments, Settings& values)
      : file_(file), arguments_(arguments), values_(values) {}

  std::vector<FileErrors> read(std::string_view text) {
    int number = 0;
    for (std::size_t at = 0; at < text.size() && errors_.size() < kMaxErrors;) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      read_line(trimmed(text.substr(at, end - at)), ++number);
      at = end + 1;
    }
    for (Error& error : check_settings(read_values_)) {
      const std::string key = error.path.substr(0, error.path.find('/'));
      add(lines_[key], std::move(error));
    }
    return std::move(errors_);
  }

 private:
  void add(int line, Error error) { errors_.push_back({file_ + ':' + std::to_string(line), {std::move(error)}}); }

  void read_line(std::string_view line, int number) {
    if (line.empty() || line.starts_with('#')) return;
    const auto equals = line.find('=');
    const std::string key(trimmed(line.substr(0, equals)));
    const auto wrong = [&](ErrorCode code, std::string message) { add(number, {code, std::move(message), key}); };
    if (std::ranges::any_of(line, is_control)) return add(number, {ErrorCode::syntax, "a control character"});
    if (equals == std::string_view::npos || key.empty())
      return add(number, {ErrorCode::syntax, "expected `key = value`"});
    const std::string value(trimmed(line.substr(equals + 1)));
    const Setting* setting = find_setting(key);
    if (!setting) return wrong(ErrorCode::unknown_field, "there is no such key" + suggestion(key, keys()));
    const auto [earlier, is_first] = lines_.emplace(key, number);
    if (!is_first)
      return wrong(ErrorCode::duplicate, "the key stands in line " + std::to_string(earlier->second) + ", too");
    if (value.starts_with('"') || value.starts_with('\''))
      return wrong(ErrorCode::syntax, "a value stands without quotes");
    if (value.find(" #") != std::string::npos || value.find("\t#") != std::string::npos || value.starts_with('#'))
      return wrong(ErrorCode::syntax, "a comment is a line of its own");
    if (auto error = read_value(*setting, value)) wrong(error->code, std::move(error->message));
  }

  // As the option of the command line.
  std::optional<Error> read_value(const Setting& setting, const std::string& value) {
    Settings into;
    Arguments one("serve");
    declare_settings(one, into);
    std::string word = setting.option();
    if (std::holds_alternative<Setting::Flag>(setting.kind)) {
      if (value != "true" && value != "false")
        return Error{ErrorCode::type, "must be true or false, got " + quote(value)};
    } else if (std::holds_alternative<Setting::File>(setting.kind)) {
      if (value.empty()) return Error{ErrorCode::missing, "the key needs a value"};
      if (value == kStandardInput) return Error{ErrorCode::not_accepted, "the standard input is for the command line"};
      word += '=' + value;
    } else {
      word += '=' + value;
    }
    if (value != "false" || word.find('=') != std::string::npos)
      if (const auto parsed = one.parse({word}); !parsed) return parsed.error();
    copy_setting(setting, into, read_values_);
    if (!arguments_.given(setting.option())) copy_setting(setting, into, values_);
    return {};
  }

  const std::string& file_;
  const Arguments& arguments_;
  Settings& values_;
  Settings read_values_;
  std::map<std::string, int> lines_;  // where each key stands
  std::vector<FileErrors> errors_;
};

bool is_json(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && (text[first] == '{' || text[first] == '[');
}

std::vector<FileErrors> read_json_config(const std::string& file, std::string_view text, const Arguments& arguments,
                                         Settings& values) {
  const auto json = parse_json(text);
  if (!json) return {{file, {json.error()}}};
  auto errors = read_settings(*json, arguments, values);
  if (errors.empty()) return {};
  return {{file, std::move(errors)}};
}

}  // namespace

std::vector<FileErrors> read_config(const std::string& file, std::string_view text, const Arguments& arguments,
                                    Settings& values) {
  if (is_json(text)) return read_json_config(file, text, arguments, values);
  return Reader(file, arguments, values).read(text);
}

}  // namespace race::server
