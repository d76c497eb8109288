#include "core/execution/derive.h"

#include <algorithm>
#include <span>

#include "core/rcm/document.h"
#include "core/value/error_list.h"
#include "core/value/json.h"

namespace race::execution {
namespace {

void add(std::vector<Error>& to, const std::vector<Error>& from) { to.insert(to.end(), from.begin(), from.end()); }

}  // namespace

Checked<Script> read_script_text(std::string_view text) {
  auto json = parse_json(text);
  if (!json) return tl::unexpected(std::vector<Error>{std::move(json).error()});
  return read_script(*json);
}

Checked<Value> derive_texts(std::string_view model, std::string_view script, OrderChoice order) {
  std::vector<Error> errors;
  auto document = rcm::read_document_text(model);
  if (!document) add(errors, document.error());
  auto steps = read_script_text(script);
  if (!steps) add(errors, steps.error());
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return derive(*document, *steps, order);
}

Value errors_json(const std::vector<Error>& errors) {
  List list;
  for (const Error& error : std::span(errors).first(std::min(errors.size(), kMaxErrors)))
    list.emplace_back(Dict{{"path", error.path}, {"code", name(error.code)}, {"message", error.message}});
  Dict json{{"errors", std::move(list)}};
  if (is_full(errors)) json.set("more_errors", true);
  return json;
}

}  // namespace race::execution
