#include "server/commands/settings.h"

#include <algorithm>

#include "core/value/fields.h"
#include "server/cell/component_groups.h"
#include "server/commands/arguments.h"
#include "server/commands/input.h"
#include "server/log/line_log.h"

namespace race::server {
namespace {

template <typename... Visitors>
struct Overloaded : Visitors... {
  using Visitors::operator()...;
};
template <typename... Visitors>
Overloaded(Visitors...) -> Overloaded<Visitors...>;

std::vector<Setting> make_table() {
  using S = Settings;
  return {
      {"port", "N", "0: any that is free", Setting::Number{&S::port, {0, 65535, true}}},
      {"lan", "", "also serves the local network, over TLS; needs accounts (race account)", Setting::Flag{&S::lan}},
      {"lan_port", "N", "of --lan; 0: any that is free", Setting::Number{&S::lan_port, {0, 65535, true}}},
      {"stop_port", "N", "where POST /api/v1/stop has a thread of its own; 0: any that is free",
       Setting::Number{&S::stop_port, {0, 65535, true}}},
      {"lan_stop_port", "N", "the same of --lan", Setting::Number{&S::lan_stop_port, {0, 65535, true}}},
      {"data", "DIR", "where documents and values are kept", Setting::Text{&S::data}},
      {"demo", "DIR", "the cell and its tasks; without, there is no robot", Setting::Text{&S::demo}},
      {"web", "DIR", "the pages; without, the interface alone", Setting::Text{&S::web}},
      {"headless", "", "no pages, whatever --web says", Setting::Flag{&S::headless}},
      {"operator", "FILE", "a person at the cell who acts by this script", Setting::File{&S::operator_script}},
      {"remote", "GROUP,...", "waits for processes (race service) that bring these: " + component_group_names(),
       Setting::Groups{&S::remote}},
      {"heartbeat", "SECONDS", "after which such a process that is silent is lost",
       Setting::Number{&S::heartbeat_s, {0.1, 3600}}},
      {"keep_runs", "N", "runs that are over; the oldest are removed", Setting::Number{&S::keep_runs, {0, 1e6, true}}},
      {"keep_mb", "N", "what these may hold [MiB]; the oldest are removed", Setting::Number{&S::keep_mb, {0, 1e6}}},
      {"log_level", "LEVEL", "of the lines on stderr: " + joined(log_level_names()) + "; each with those before it",
       Setting::Choice{&S::log_level, log_level_names()}},
  };
}

// Reads a setting from its field into `values`; errors go to those of `fields`.
void read(const Setting& setting, Fields& fields, Settings& values) {
  const std::string& key = setting.key;
  const auto set = [](auto& to, auto&& from) {
    if (from) to = *from;
  };
  std::visit(Overloaded{
                 [&](const Setting::Number& of) {
                   const auto value = fields.number(key);
                   if (value && !of.range.has(*value))
                     fields.violation(ErrorCode::out_of_range, quote(key) + " must be " + of.range.text(), key);
                   set(values.*of.value, value);
                 },
                 [&](const Setting::Text& of) { set(values.*of.value, fields.text(key)); },
                 [&](const Setting::Choice& of) {
                   const auto value = fields.text(key);
                   if (value && std::ranges::find(of.words, *value) == of.words.end())
                     fields.violation(ErrorCode::out_of_range, quote(key) + " must be one of " + joined(of.words), key);
                   set(values.*of.value, value);
                 },
                 [&](const Setting::Flag& of) { set(values.*of.value, fields.boolean(key)); },
                 [&](const Setting::File& of) {
                   const auto value = fields.text(key);
                   if (value && *value == kStandardInput)
                     fields.violation(ErrorCode::not_accepted, "the standard input is for the command line", key);
                   set(values.*of.value, value);
                 },
                 [&](const Setting::Groups& of) {
                   if (fields.find(key)) values.*of.value = fields.texts(key);
                 },
             },
             setting.kind);
}

}  // namespace

void copy_setting(const Setting& setting, const Settings& from, Settings& to) {
  std::visit([&](const auto& of) { to.*of.value = from.*of.value; }, setting.kind);
}

std::string Setting::option() const {
  std::string name = "--" + key;
  std::ranges::replace(name, '_', '-');
  return name;
}

std::span<const Setting> settings() {
  static const std::vector<Setting> table = make_table();
  return table;
}

void declare_settings(Arguments& arguments, Settings& values) {
  for (const Setting& setting : settings()) {
    const std::string option = setting.option();
    const auto& [key, placeholder, meaning, kind] = setting;
    const std::string& help = meaning;
    const std::string& place = placeholder;
    std::visit(
        Overloaded{
            [&](const Setting::Number& of) { arguments.number(option, place, values.*of.value, of.range, help); },
            [&](const Setting::Text& of) { arguments.text(option, place, values.*of.value, help); },
            [&](const Setting::Choice& of) { arguments.choice(option, place, values.*of.value, of.words, help); },
            [&](const Setting::Flag& of) { arguments.flag(option, values.*of.value, help); },
            [&](const Setting::File& of) { arguments.file(option, place, values.*of.value, help); },
            [&](const Setting::Groups& of) { arguments.names(option, place, values.*of.value, help); },
        },
        kind);
  }
}

std::vector<Error> check_settings(const Settings& values) {
  std::vector<Error> errors;
  for (std::size_t i = 0; i < values.remote.size(); ++i) {
    const std::string path = "remote/" + std::to_string(i);
    if (const auto group = find_component_group(values.remote[i]); !group)
      errors.push_back({group.error().code, group.error().message, path});
    else if (std::find(values.remote.begin(), values.remote.begin() + static_cast<std::ptrdiff_t>(i),
                       values.remote[i]) != values.remote.begin() + static_cast<std::ptrdiff_t>(i))
      errors.push_back({ErrorCode::duplicate, quote(values.remote[i]) + " stands twice", path});
  }
  return errors;
}

std::vector<Error> read_settings(const Value& json, const Arguments& arguments, Settings& values) {
  std::vector<Error> errors;
  Settings read_values;
  Fields fields(json, "", "the configuration", errors, kByField);
  for (const Setting& setting : settings()) read(setting, fields, read_values);
  fields.close();
  for (Error& error : check_settings(read_values)) errors.push_back(std::move(error));
  for (const Setting& setting : settings())
    if (!arguments.given(setting.option()) && json.find(setting.key)) copy_setting(setting, read_values, values);
  return errors;
}

}  // namespace race::server
