// What a program has said of a service: its operations and events, and where; and the RSM that this comes to. Pure, but
// for read_rsm_file().
#pragma once

#include <functional>
#include <list>
#include <optional>
#include <source_location>
#include <string>
#include <string_view>
#include <vector>

#include "api/cpp/race_client/service.h"
#include "core/rsm/model.h"
#include "core/value/expected.h"

namespace race::client {

struct DeclaredOperation {
  rsm::Operation model;
  std::string busy, stops;  // states; empty: none
  Operation::Handler handler;
  std::source_location place;
};

struct DeclaredEvent {
  rsm::Event model;
  std::source_location place;
};

struct Declaration {
  std::string key, type, version;
  std::source_location place;
  std::list<DeclaredOperation> operations;  // each stays where it is
  std::vector<DeclaredEvent> events;
  std::optional<std::string> rsm_text;  // of one's own
  std::string rsm_file;                 // that it was read from
  std::function<void()> on_halt;
};

/// Sets the RSM of one's own; if there is no such file, model_of() says so.
void read_rsm_file(Declaration& declaration, std::string path);

/// The operation of this name; nullptr: none is declared.
const DeclaredOperation* find_operation(const Declaration& declaration, std::string_view name);

/// The RSM: made of the declaration, or of one's own. The error is `FILE:LINE: error: MESSAGE`, a line for each.
tl::expected<rsm::Service, std::string> model_of(const Declaration& declaration);

/// FILE:LINE where the first of these names is declared that is; else that of the service.
std::string place_of(const Declaration& declaration, const std::vector<std::string>& names);
/// The same of a text about `operation`, if it is not empty, and the names that it has in backquotes.
std::string place_of_text(const Declaration& declaration, const std::string& operation, std::string_view text);

}  // namespace race::client
