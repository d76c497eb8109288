// GET and PUT /api/v1/boot: what the server starts when it begins.
#include "core/value/json.h"
#include "server/handlers/handlers.h"
#include "server/store/boot_list.h"
#include "server/store/documents.h"

namespace race::server {

namespace {

Handled boot_json(const std::vector<BootEntry>& entries) {
  List list;
  for (const BootEntry& entry : entries)
    list.push_back(Dict{{"document", entry.document}, {"arguments", entry.arguments}});
  return ok(Dict{{"entries", std::move(list)}});
}

Checked<std::vector<BootEntry>> read_entries(const std::string& text) {
  auto body = parse_json(text);
  if (!body) return failed(std::move(body).error());
  std::vector<Error> errors;
  Fields fields(*body, "", "the request", errors, Fields::Paths::field);
  const List& list = fields.list("entries", Fields::Need::required);
  fields.close();
  std::vector<BootEntry> entries;
  for (std::size_t i = 0; i < list.size(); ++i) {
    Fields of_one(list[i], "entries/" + std::to_string(i), "an entry", errors, Fields::Paths::field);
    std::string document = of_one.text("document", Fields::Need::required).value_or("");
    entries.push_back({std::move(document), read_arguments(of_one).value_or(Dict())});
    of_one.close();
  }
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  if (auto fine = BootList::check(entries); !fine) return failed(std::move(fine).error());
  return entries;
}

// Every entry whose document is not there. One with violations is there: it is logged when it cannot be started.
Checked<void> find_documents(const std::vector<BootEntry>& entries, Documents& documents) {
  std::vector<Error> errors;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const auto stored = documents.get(entries[i].document);
    if (stored || stored.error().front().code != ErrorCode::not_found) continue;
    errors.push_back({ErrorCode::not_found, "there is no document `" + entries[i].document + '`',
                      "entries/" + std::to_string(i) + "/document"});
  }
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return {};
}

}  // namespace

Handled get_boot(const Request&, BootList& boot) {
  const auto entries = boot.get();
  if (!entries) return failed(entries.error());
  return boot_json(*entries);
}

Handled put_boot(const Request& request, Documents& documents, BootList& boot) {
  const auto entries = read_entries(request.body);
  if (!entries) return tl::unexpected(entries.error());
  if (const auto found = find_documents(*entries, documents); !found) return tl::unexpected(found.error());
  if (auto set = boot.set(*entries); !set) return failed(std::move(set).error());
  return boot_json(*entries);
}

}  // namespace race::server
