// Presence: who is at which document, what they do there, and what of that has not been told yet. A state without
// socket and clock: what happens goes in, what is to be told comes out. What a person says replaces what they said
// before, so however much they say, the last of it is told, kPeriod after the last time at the latest.
//
// A name is no identity: a person is known by the id that they get here, which nobody else ever gets.
//
// Threads: one.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::server {

class Presence {
 public:
  static constexpr std::size_t kMostPeople = 64;           // at a document
  static constexpr std::int64_t kColours = 8;              // that pages have for persons
  static constexpr std::chrono::milliseconds kPeriod{40};  // of a document, from one delta to the next

  using Time = std::chrono::steady_clock::time_point;
  /// A connection; it is at one document at a time.
  using Place = const void*;

  /// `first_id`: greater than all of an earlier server's.
  explicit Presence(std::int64_t first_id = 1) : next_id_(first_id) {}

  struct Shown {
    std::int64_t id;
    bool is_new;  // the person has come, or is back
  };
  /// The person at `place` is at the document and does this; they leave another document. Error `too_large`:
  /// kMostPeople are there; then they are at none. `person` is a dict.
  Expected<Shown> show(Place place, const std::string& document, Value person, Time now);
  /// They are at no document any more.
  void leave(Place place);
  /// They are not at this document.
  void leave(Place place, const std::string& document);
  /// Those who have said nothing since `before` leave.
  void drop_silent(Time before);
  bool empty() const { return places_.empty(); }
  /// How many documents are kept: those with people, and those that somebody has left a moment ago.
  std::size_t documents() const { return documents_.size(); }

  /// Of schemas/presence.json, frozen: `presence_snapshot`, with what has not been told yet.
  Value snapshot(const std::string& document) const;
  struct Delta {
    std::string document;
    Value data;  // `presence_delta`
  };
  /// What is to be told now.
  std::vector<Delta> take_due(Time now);
  /// When there is more; nothing: all is told.
  std::optional<Time> next_due() const;

 private:
  struct Person {
    Place place;
    Value shown;  // with id and colour
    Time heard;
  };
  struct Document {
    std::map<std::int64_t, Person> people;  // by id
    std::set<std::int64_t> changed;         // not told yet; those who are not in `people` have left
    Time quiet_until{};                     // no delta before

    std::int64_t free_colour() const;
    Value take_delta();
  };
  struct Where {
    std::string document;
    std::int64_t id;
  };

  std::map<std::string, Document, std::less<>> documents_;  // with people, or with something to tell
  std::map<Place, Where> places_;
  std::int64_t next_id_;
};

}  // namespace race::server
