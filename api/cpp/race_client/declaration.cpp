#include "api/cpp/race_client/declaration.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <utility>

#include "api/cpp/race_client/generated_rsm.h"
#include "api/cpp/race_client/values.h"
#include "core/rsm/document.h"
#include "core/value/fields.h"
#include "services/remote/own_services.h"

namespace race::client {
namespace {

std::string text_of(const std::source_location& place) {
  return std::string(place.file_name()) + ":" + std::to_string(place.line());
}

// The number of the first line that has the name in quotes; 0: none has.
std::size_t line_with(std::string_view text, const std::string& name) {
  const auto found = text.find('"' + name + '"');
  if (found == std::string_view::npos) return 0;
  return 1 + static_cast<std::size_t>(std::ranges::count(text.substr(0, found), '\n'));
}

// Empty: it is not declared.
std::string find_place(const Declaration& declaration, const std::string& name) {
  if (!declaration.rsm_file.empty() && declaration.rsm_text)
    if (const std::size_t line = line_with(*declaration.rsm_text, name))
      return declaration.rsm_file + ":" + std::to_string(line);
  for (const DeclaredOperation& each : declaration.operations)
    if (each.model.name == name) return text_of(each.place);
  for (const DeclaredEvent& each : declaration.events)
    if (each.model.name == name) return text_of(each.place);
  for (const DeclaredOperation& each : declaration.operations)
    if (each.busy == name || each.stops == name) return text_of(each.place);
  return {};
}

std::string error_at(const std::string& place, const std::string& message) { return place + ": error: " + message; }

std::string errors_of(const Declaration& declaration, const std::vector<Error>& errors) {
  std::string lines;
  for (const Error& error : errors) {
    if (!lines.empty()) lines += '\n';
    lines += error_at(place_of_text(declaration, "", error.message), error.message);
  }
  return lines;
}

bool is_key(const std::string& text) { return is_name(text) && text.size() <= remote::OwnServices::kKeyBytes; }

// What is wrong before there is an RSM; empty: nothing.
std::string error_of(const Declaration& declaration) {
  for (const std::string& name : {declaration.key, declaration.type})
    if (!is_key(name))
      return error_at(text_of(declaration.place), "a key or type has letters, digits and `_`, at most " +
                                                      std::to_string(remote::OwnServices::kKeyBytes) + ", and is not " +
                                                      quote(name));
  if (!declaration.rsm_file.empty() && !declaration.rsm_text)
    return error_at(declaration.rsm_file + ":1", "the file cannot be read");
  for (const DeclaredOperation& each : declaration.operations) {
    const std::string place = text_of(each.place), name = quote(each.model.name);
    if (!each.handler) return error_at(place, name + " does nothing: `does` is missing");
    if (!each.busy.empty() && !each.stops.empty())
      return error_at(place, name + " is busy, and cannot stop another: have an operation for that");
    const bool is_busy = std::ranges::any_of(declaration.operations,
                                             [&](const DeclaredOperation& other) { return other.busy == each.stops; });
    if (!declaration.rsm_text && !each.stops.empty() && !is_busy)
      return error_at(place, name + " stops " + quote(each.stops) + ", in which nothing is busy");
  }
  return {};
}

// The same as soon as there is one: whether both have the same operations.
std::string error_of(const Declaration& declaration, const rsm::Service& model) {
  for (const rsm::Operation& each : model.operations)
    if (!find_operation(declaration, each.name))
      return error_at(place_of(declaration, {each.name}),
                      "the RSM has the operation " + quote(each.name) + ", and the service does not");
  for (const DeclaredOperation& each : declaration.operations)
    if (std::ranges::find(model.operations, each.model.name, &rsm::Operation::name) == model.operations.end())
      return error_at(text_of(each.place), "the RSM has no operation " + quote(each.model.name));
  return {};
}

Checked<rsm::Service> read_model(const Declaration& declaration) {
  if (declaration.rsm_text) return rsm::read_service_text(*declaration.rsm_text, declaration.key);
  const Value json = rsm::write_service(generated_rsm(declaration));
  if (const auto why = unsayable(json)) {
    std::vector<Error> errors;
    errors.push_back({ErrorCode::constant, "the declaration of " + quote(declaration.key) + " " + *why});
    return tl::unexpected(std::move(errors));
  }
  return rsm::read_service(json, declaration.key);
}

}  // namespace

void read_rsm_file(Declaration& declaration, std::string path) {
  std::ifstream file(path, std::ios::binary);
  declaration.rsm_text.reset();
  if (file) declaration.rsm_text.emplace(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  declaration.rsm_file = std::move(path);
}

const DeclaredOperation* find_operation(const Declaration& declaration, std::string_view name) {
  for (const DeclaredOperation& each : declaration.operations)
    if (each.model.name == name) return &each;
  return nullptr;
}

tl::expected<rsm::Service, std::string> model_of(const Declaration& declaration) {
  if (std::string wrong = error_of(declaration); !wrong.empty()) return tl::unexpected(std::move(wrong));
  auto model = read_model(declaration);
  if (!model) return tl::unexpected(errors_of(declaration, model.error()));
  if (std::string wrong = error_of(declaration, *model); !wrong.empty()) return tl::unexpected(std::move(wrong));
  return std::move(*model);
}

std::string place_of(const Declaration& declaration, const std::vector<std::string>& names) {
  for (const std::string& name : names)
    if (std::string place = find_place(declaration, name); !place.empty()) return place;
  return declaration.rsm_file.empty() ? text_of(declaration.place) : declaration.rsm_file + ":1";
}

std::string place_of_text(const Declaration& declaration, const std::string& operation, std::string_view text) {
  std::vector<std::string> names;
  if (!operation.empty()) names.push_back(operation);
  for (auto begin = text.find('`'); begin != std::string_view::npos;) {
    const auto end = text.find('`', begin + 1);
    if (end == std::string_view::npos) break;
    names.emplace_back(text.substr(begin + 1, end - begin - 1));
    begin = text.find('`', end + 1);
  }
  return place_of(declaration, names);
}

}  // namespace race::client
