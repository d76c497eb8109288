#include "server/editing/presence.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace race::server {
namespace {

Value with(Value person, std::int64_t id, std::int64_t colour) {
  Dict& fields = person.mutable_dict();
  fields.set("id", id);
  fields.set("colour", colour);
  return std::move(person.freeze());
}

}  // namespace

// The one that fewest have.
std::int64_t Presence::Document::free_colour() const {
  std::array<int, kColours> used{};
  for (const auto& [id, person] : people) ++used[static_cast<std::size_t>(person.shown.find("colour")->as_integer())];
  return std::ranges::min_element(used) - used.begin();
}

Expected<Presence::Shown> Presence::show(Place place, const std::string& name, Value person, Time now) {
  const auto at = places_.find(place);
  if (at != places_.end() && at->second.document == name) {
    Document& document = documents_.at(name);
    const std::int64_t id = at->second.id;
    Person& known = document.people.at(id);
    known.heard = now;
    person = with(std::move(person), id, known.shown.find("colour")->as_integer());
    if (person != known.shown) document.changed.insert(id);
    known.shown = std::move(person);
    return Shown{id, false};
  }
  leave(place);
  const auto there = documents_.find(name);
  if (there != documents_.end() && there->second.people.size() >= kMostPeople)
    return unexpected(
        ErrorCode::too_large,
        std::to_string(kMostPeople) + " people are at the document: others do not see you, you can edit it",
        "document");
  Document& document = documents_[name];
  const std::int64_t id = next_id_++;
  person = with(std::move(person), id, document.free_colour());
  document.people.emplace(id, Person{place, std::move(person), now});
  document.changed.insert(id);
  places_.insert_or_assign(place, Where{name, id});
  return Shown{id, true};
}

void Presence::leave(Place place) {
  const auto at = places_.find(place);
  if (at == places_.end()) return;
  Document& document = documents_.at(at->second.document);
  document.people.erase(at->second.id);
  document.changed.insert(at->second.id);
  places_.erase(at);
}

void Presence::leave(Place place, const std::string& document) {
  const auto at = places_.find(place);
  if (at != places_.end() && at->second.document == document) leave(place);
}

void Presence::drop_silent(Time before) {
  std::vector<Place> silent;
  for (const auto& [place, where] : places_)
    if (documents_.at(where.document).people.at(where.id).heard < before) silent.push_back(place);
  for (Place place : silent) leave(place);
}

Value Presence::snapshot(const std::string& name) const {
  List people;
  if (const auto document = documents_.find(name); document != documents_.end())
    for (const auto& [id, person] : document->second.people) people.push_back(person.shown);
  Value out(Dict{{"people", std::move(people)}});
  return std::move(out.freeze());
}

Value Presence::Document::take_delta() {
  List there, left;
  for (const std::int64_t id : changed) {
    const auto person = people.find(id);
    if (person != people.end())
      there.push_back(person->second.shown);
    else
      left.emplace_back(id);
  }
  changed.clear();
  Value out(Dict{{"people", std::move(there)}, {"left", std::move(left)}});
  return std::move(out.freeze());
}

std::vector<Presence::Delta> Presence::take_due(Time now) {
  std::vector<Delta> due;
  for (auto document = documents_.begin(); document != documents_.end();) {
    auto& [name, of] = *document;
    if (of.quiet_until <= now && !of.changed.empty()) {
      due.push_back({name, of.take_delta()});
      of.quiet_until = now + kPeriod;
    }
    const bool is_over = of.people.empty() && of.quiet_until <= now;
    document = is_over ? documents_.erase(document) : std::next(document);
  }
  return due;
}

std::optional<Presence::Time> Presence::next_due() const {
  std::optional<Time> next;
  for (const auto& [name, document] : documents_)
    if (!document.changed.empty() && (!next || document.quiet_until < *next)) next = document.quiet_until;
  return next;
}

}  // namespace race::server
