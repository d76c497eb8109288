#include "services/display/screens.h"

#include <algorithm>
#include <utility>

namespace race::display {
namespace {

/// Why `answer` is none of `question`.
Expected<void> check_answer(const Question& question, const Value& answer) {
  if (!question.number) {
    const bool known = answer.is_string() && std::ranges::count(question.buttons, answer.as_string()) > 0;
    if (!known) return unexpected(ErrorCode::type, "the answer must be one of the question's buttons", "answer");
    return {};
  }
  if (!answer.is_numeric()) return unexpected(ErrorCode::type, "the answer must be a number", "answer");
  const double number = answer.to_double();
  if (!(number >= question.number->min && number <= question.number->max))
    return unexpected(ErrorCode::out_of_range, "the number is outside of its limits", "answer");
  return {};
}

/// Of a target; empty: it names none.
std::string_view place_of(std::string_view target) {
  return target.starts_with('@') ? target.substr(1) : std::string_view();
}

}  // namespace

bool is_display_name(std::string_view name) {
  constexpr std::size_t kLength = 32;
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  return !name.empty() && name.size() <= kLength && std::ranges::all_of(name, fits) && name != kAllDisplays;
}

bool is_display_target(std::string_view target) {
  return target == kAllDisplays || is_display_name(target.starts_with('@') ? place_of(target) : target);
}

Expected<Screens::ConnectionId> Screens::connect(const std::string& display, bool sound, const std::string& place) {
  if (!is_display_name(display))
    return unexpected(ErrorCode::name, "a display's name has 1 to 32 letters, digits, `_` or `-`, and is not `all`",
                      "name");
  if (!place.empty() && !is_display_name(place))
    return unexpected(ErrorCode::name, "a place has 1 to 32 letters, digits, `_` or `-`, and is not `all`", "place");
  const services::MutexLock lock(mutex_);
  if (!displays_.contains(display)) {
    if (!make_room())
      return unexpected(ErrorCode::conflict, std::to_string(kDisplays) + " displays are connected already", "name");
    displays_[display].shown = everywhere_;
  }
  const ConnectionId id = next_id_++;
  ++revision_;
  connections_[id] = {display, sound, place};
  Display& connected = displays_[display];
  connected.connections.insert(id);
  const bool moved = update_place(display, connected);
  if (moved || connected.connections.size() == 1)
    (void)enqueue({DisplayEvent::Kind::connected, display, {}, 0, connected.place});
  return id;
}

void Screens::disconnect(ConnectionId connection) {
  const services::MutexLock lock(mutex_);
  const auto known = connections_.find(connection);
  if (known == connections_.end()) return;
  const std::string display = known->second.display;
  connections_.erase(known);
  ++revision_;
  playing_.erase(connection);
  Display& left = displays_[display];
  left.connections.erase(connection);
  if (left.connections.empty())
    (void)enqueue({DisplayEvent::Kind::disconnected, display, {}, 0, left.place});
  else if (update_place(display, left))
    (void)enqueue({DisplayEvent::Kind::connected, display, {}, 0, left.place});
}

Expected<void> Screens::answer(const std::string& display, Value answer, std::optional<std::uint64_t> question) {
  answer.freeze();
  const services::MutexLock lock(mutex_);
  ASSIGN_OR_RETURN(const Display* shown, find_connected(display));
  if (!shows_question(display, *shown) || (question && *question != question_->id))
    return unexpected(ErrorCode::conflict, "the display does not show this question, or not any more", "question");
  if (auto fits = check_answer(*question_, answer); !fits) return fits;
  if (auto enqueued = enqueue({DisplayEvent::Kind::answered, display, std::move(answer), question_->id}); !enqueued)
    return enqueued;
  question_.reset();
  notify_watcher(question_target_);
  return {};
}

Expected<void> Screens::press(const std::string& display, const std::string& button) {
  const services::MutexLock lock(mutex_);
  ASSIGN_OR_RETURN(const Display* shown, find_connected(display));
  const std::optional<Message>& message = shown->shown.message;
  if (!message || std::ranges::count(message->buttons, button) == 0)
    return unexpected(ErrorCode::conflict, "the display does not show this button, or not any more", "button");
  Value value(button);
  return enqueue({DisplayEvent::Kind::pressed, display, std::move(value.freeze())});
}

Expected<void> Screens::played(ConnectionId connection, std::uint64_t sound) {
  const services::MutexLock lock(mutex_);
  const auto known = connections_.find(connection);
  if (known == connections_.end() || !sound_ || sound_->id != sound || playing_.erase(connection) == 0)
    return unexpected(ErrorCode::conflict, "the sound is not played here, or not any more", "sound");
  played_.insert(known->second.display);
  ++revision_;
  return {};
}

std::vector<std::string> Screens::connected() const {
  const services::MutexLock lock(mutex_);
  std::vector<std::string> names;
  for (const auto& [name, display] : displays_)
    if (!display.connections.empty()) names.push_back(name);
  return names;
}

std::optional<Content> Screens::content(const std::string& display) const {
  const services::MutexLock lock(mutex_);
  const auto known = displays_.find(display);
  if (known == displays_.end()) return std::nullopt;
  return content_of(known->first, known->second);
}

void Screens::watch(Watcher* watcher) {
  const services::MutexLock lock(mutex_);
  watcher_ = watcher;
}

void Screens::repeat(const std::string& display) {
  const services::MutexLock lock(mutex_);
  const auto known = displays_.find(display);
  if (known != displays_.end() && watcher_) watcher_->changed(content_of(known->first, known->second));
}

Expected<void> Screens::show(const std::string& target, Message message) {
  const services::MutexLock lock(mutex_);
  if (auto connected = require_connected(target); !connected) return connected;
  const std::uint64_t order = next_id_++;
  const auto show_on = [&](Shown& shown) {
    shown.message = message;
    shown.order = order;
  };
  for (auto& [name, display] : displays_)
    if (reaches(target, name, display)) show_on(display.shown);
  if (Shown* later = remembered(target)) show_on(*later);
  notify_watcher(target);
  return {};
}

Expected<std::uint64_t> Screens::ask(const std::string& target, Question question) {
  const services::MutexLock lock(mutex_);
  if (auto connected = require_connected(target); !connected) return tl::unexpected(std::move(connected).error());
  if (std::exchange(question_, std::nullopt)) notify_watcher(question_target_);
  question.id = next_id_++;
  question_ = std::move(question);
  question_target_ = target;
  for (auto& [name, display] : displays_) display.shown.without_question = false;
  for (auto& [name, shown] : places_) shown.without_question = false;
  everywhere_.without_question = false;
  notify_watcher(target);
  return question_->id;
}

Expected<bool> Screens::clear(const std::string& target) {
  const services::MutexLock lock(mutex_);
  const bool known =
      std::ranges::any_of(displays_, [&](const auto& each) { return reaches(target, each.first, each.second); });
  if (target != kAllDisplays && !known && !places_.contains(std::string(place_of(target))))
    if (auto connected = require_connected(target); !connected) return tl::unexpected(std::move(connected).error());
  const Shown cleared{std::nullopt, true, next_id_++};
  for (auto& [name, display] : displays_)
    if (reaches(target, name, display)) display.shown = cleared;
  if (Shown* later = remembered(target)) *later = cleared;
  const bool shown = std::ranges::any_of(
      displays_, [&](const auto& each) REQUIRES(mutex_) { return shows_question(each.first, each.second); });
  const bool gone = question_ && !shown;
  if (gone) question_.reset();
  notify_watcher(target);
  return gone;
}

void Screens::withdraw() {
  const services::MutexLock lock(mutex_);
  if (std::exchange(question_, std::nullopt)) notify_watcher(question_target_);
}

bool Screens::asking() {
  const services::MutexLock lock(mutex_);
  return std::ranges::any_of(displays_, [&](const auto& each) REQUIRES(mutex_) {
    return !each.second.connections.empty() && shows_question(each.first, each.second);
  });
}

std::vector<DisplayEvent> Screens::take() {
  const services::MutexLock lock(mutex_);
  return std::exchange(events_, {});
}

Expected<std::uint64_t> Screens::play(const std::string& target, Sound sound) {
  const services::MutexLock lock(mutex_);
  std::set<ConnectionId> speakers;
  for (const auto& [id, connection] : connections_)
    if (connection.sound && reaches(target, connection.display, displays_[connection.display])) speakers.insert(id);
  if (speakers.empty())
    return unexpected(ErrorCode::not_found, "no display that may make sounds is connected as " + quote(target),
                      "display");
  if (std::exchange(sound_, std::nullopt)) notify_watcher(sound_target_);
  sound.id = next_id_++;
  sound_ = std::move(sound);
  sound_target_ = target;
  playing_ = std::move(speakers);
  played_.clear();
  notify_watcher(target);
  return sound_->id;
}

void Screens::silence() {
  const services::MutexLock lock(mutex_);
  playing_.clear();
  played_.clear();
  if (std::exchange(sound_, std::nullopt)) notify_watcher(sound_target_);
}

Playback Screens::playback() {
  const services::MutexLock lock(mutex_);
  return {playing_.size(), {played_.begin(), played_.end()}};
}

bool Screens::reaches(const std::string& target, const std::string& name, const Display& display) {
  if (target == kAllDisplays || target == name) return true;
  return !display.place.empty() && place_of(target) == display.place;
}

/// After a connection has come or gone. Whether the display is elsewhere now.
bool Screens::update_place(const std::string& name, Display& display) {
  std::string place;
  for (const ConnectionId id : display.connections)
    if (const std::string& named = connections_[id].place; !named.empty()) place = named;
  if (place == display.place) return false;
  display.place = std::move(place);
  if (const auto here = places_.find(display.place); here != places_.end()) {
    const bool cleared = display.shown.without_question;
    if (here->second.order > display.shown.order) display.shown = here->second;
    display.shown.without_question |= cleared;
  }
  if (watcher_) watcher_->changed(content_of(name, display));
  return true;
}

/// What displays show that are reached by `target` later; nullptr: only one that is there is.
Screens::Shown* Screens::remembered(const std::string& target) {
  if (target == kAllDisplays) {
    places_.clear();  // older than what follows
    return &everywhere_;
  }
  if (place_of(target).empty()) return nullptr;
  Shown& place = places_[std::string(place_of(target))];
  if (places_.size() > kDisplays) forget_a_place();
  return &place;
}

/// The one where nothing was shown for the longest time, and where no display is that is known: those are at most
/// kDisplays.
void Screens::forget_a_place() {
  auto oldest = places_.end();
  for (auto each = places_.begin(); each != places_.end(); ++each) {
    const bool used = std::ranges::any_of(displays_, [&](const auto& one) { return one.second.place == each->first; });
    if (!used && (oldest == places_.end() || each->second.order < oldest->second.order)) oldest = each;
  }
  if (oldest != places_.end()) places_.erase(oldest);
}

bool Screens::shows_question(const std::string& name, const Display& display) const {
  return question_ && reaches(question_target_, name, display) && !display.shown.without_question;
}

Content Screens::content_of(const std::string& name, const Display& display) const {
  Content content{name, display.shown.message, std::nullopt, std::nullopt};
  if (shows_question(name, display)) content.question = question_;
  if (sound_ && reaches(sound_target_, name, display)) content.sound = sound_;
  return content;
}

void Screens::notify_watcher(const std::string& target) const {
  if (!watcher_) return;
  for (const auto& [name, display] : displays_)
    if (reaches(target, name, display)) watcher_->changed(content_of(name, display));
}

// One more name: a display that is not connected makes way.
bool Screens::make_room() {
  if (displays_.size() < kDisplays) return true;
  const auto gone = std::ranges::find_if(displays_, [](const auto& each) { return each.second.connections.empty(); });
  if (gone == displays_.end()) return false;
  if (watcher_) watcher_->forgotten(gone->first);
  displays_.erase(gone);
  return true;
}

Expected<Screens::Display*> Screens::find_connected(const std::string& display) {
  const auto known = displays_.find(display);
  if (known == displays_.end() || known->second.connections.empty())
    return unexpected(ErrorCode::not_found, "no display named " + quote(display) + " is connected", "display");
  return &known->second;
}

Expected<void> Screens::require_connected(const std::string& target) const {
  for (const auto& [name, display] : displays_)
    if (reaches(target, name, display) && !display.connections.empty()) return {};
  return unexpected(ErrorCode::not_found, absent(target), "display");
}

// What is missing, the page that would be it, and which there are.
std::string Screens::absent(const std::string& target) const {
  if (target == kAllDisplays) return "no display is connected: open /display/ on one";
  const std::string place(place_of(target));
  std::set<std::string> there;
  for (const auto& [name, display] : displays_)
    if (const std::string& found = place.empty() ? name : display.place; !display.connections.empty() && !found.empty())
      there.insert(quote((place.empty() ? "" : "@") + found));
  std::string text = place.empty()
                         ? "no display named " + quote(target) + " is connected: open /display/?name=" + target
                         : "no display at the place " + quote(place) + " is connected: open /display/?place=" + place +
                               " on the one there";
  std::size_t named = 0;
  for (const std::string& one : there) {
    if (named == kNamed) return text + ", and more";
    text += (named++ == 0 ? ", or write one that is: " : ", ") + one;
  }
  return text;
}

// Comings and goings follow from what is connected, so they may be lost; what people do is refused instead.
Expected<void> Screens::enqueue(DisplayEvent event) {
  if (events_.size() >= kMaxPendingEvents)
    return unexpected(ErrorCode::conflict, "too much waits for the service; try again");
  events_.push_back(std::move(event));
  ++revision_;
  return {};
}

}  // namespace race::display
