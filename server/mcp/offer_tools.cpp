// Tools of what a task can use: skills, which documents have, and services.
#include "server/mcp/skills.h"
#include "server/mcp/tool.h"

namespace race::server::mcp {
namespace {

constexpr int kDocumentsRead = 50;  // that are read for one answer

const List kEmpty;

const List& items_of(const Value& answer, std::string_view key) {
  const Value* items = answer.find(key);
  return items && items->is_list() ? items->as_list() : kEmpty;
}

std::string string_of(const Value& element, std::string_view key) {
  const Value* text = element.find(key);
  return text && text->is_string() ? text->as_string() : std::string();
}

void append_skills(const Value& entry, const std::string& name, List& skills) {
  if (const Value* document = entry.find("document"))
    for (Value& skill : skills_of(name, *document)) skills.push_back(std::move(skill));
}

Value service_json(const Value& service) {
  Dict json;
  for (const char* key : {"key", "type", "state", "available"})
    if (const Value* value = service.find(key)) json.set(key, *value);
  const Value* rsm = service.find("rsm");
  for (const char* key : {"operations", "events"})
    if (const Value* value = rsm ? rsm->find(key) : nullptr) json.set(key, *value);
  return json;
}

}  // namespace

// A document that cannot be read has no skills for anybody: it is named, and the others are read.
Outcome list_skills(const Context& context, const Dict& arguments) {
  List skills, unread;
  if (const Value* name = arguments.find("document")) {
    const auto entry = context.api.get(Target{"documents", name->as_string()});
    if (!entry) return entry;
    append_skills(*entry, name->as_string(), skills);
    return Dict{{"skills", std::move(skills)}};
  }
  const Value limit(kDocumentsRead);
  const auto page = context.api.get(Target{"documents"}.with("after", arguments.find("after")).with("limit", &limit));
  if (!page) return page;
  for (const Value& summary : items_of(*page, "documents")) {
    if (context.cancelled) break;
    const std::string name = string_of(summary, "name");
    const auto entry = context.api.get(Target{"documents", name});
    if (entry)
      append_skills(*entry, name, skills);
    else
      unread.emplace_back(name);
  }
  Dict answer{{"skills", std::move(skills)}};
  if (!unread.empty()) answer.set("unread", std::move(unread));
  if (const Value* next = page->find("next")) answer.set("next", *next);
  return answer;
}

Outcome list_services(const Context& context, const Dict& arguments) {
  const auto all = context.api.get(Target{"services"});
  const Value* key = arguments.find("service");
  if (!all) return all;
  List services;
  for (const Value& service : items_of(*all, "services")) {
    if (!key) services.push_back(service_json(service));
    if (key && string_of(service, "key") == key->as_string()) return service;
  }
  if (key) return tl::unexpected(make_problem({ErrorCode::not_found, "there is no such service", key->as_string()}));
  return Dict{{"services", std::move(services)}};
}

}  // namespace race::server::mcp
