#include "services/remote/remotes.h"

#include <algorithm>
#include <utility>

#include "core/rsm/document.h"
#include "core/value/fields.h"
#include "services/time_slice.h"

namespace race::remote {
namespace {

constexpr double kShare = 0.2;  // of a processor, for what the processes of a group say

tl::unexpected<Error> taken(std::string what) {
  return unexpected(ErrorCode::conflict, "has a process already", std::move(what));
}

}  // namespace

Remotes::Remotes(services::Host& host, const services::Clock& clock, std::chrono::milliseconds heartbeat)
    : host_(host), clock_(clock), heartbeat_(heartbeat) {}

Remotes::~Remotes() { stop(); }

void Remotes::add(std::string name, const std::vector<RemoteService>& services, RemoteWorld* world) {
  const services::MutexLock lock(mutex_);
  names_.push_back(std::move(name));
  worlds_.push_back(world);
  groups_.push_back(std::make_unique<services::WorkThread>("processes", kShare));
  groups_.back()->post(services::shorten_time_slice);
  for (const RemoteService& service : services) {
    services::ServiceHost& host = host_.declare(service.key, service.type, *groups_.back());
    auto component = std::make_unique<RemoteComponent>(service.key, *service.model, host, service.host_functions);
    places_.emplace(service.key, Place{service, groups_.size() - 1, component.get()});
    host_.attach(service.key, std::move(component), services::Host::Connection::disconnected);
  }
}

void Remotes::step() {
  for (const auto& [key, place] : places_) {
    if (!place.service.host_functions.version) continue;
    const std::uint64_t version = place.service.host_functions.version();
    if (std::exchange(versions_[key], version) != version)
      post(place.group, [component = place.component] { component->notify_changes(); });
  }
}

void Remotes::stop() {
  std::vector<services::WorkThread*> ending;  // without the lock: their work may take it
  {
    const services::MutexLock lock(mutex_);
    for (const auto& group : groups_) ending.push_back(group.get());
  }
  for (services::WorkThread* group : ending) group->end();
}

// The places of what a process brings, claimed or not.
Expected<std::vector<const Remotes::Place*>> Remotes::find(const Value& components) const {
  if (components.as_list().empty()) return unexpected(ErrorCode::missing, "there is no component", "components");
  std::vector<const Place*> places;
  for (const Value& json : components.as_list()) {
    std::vector<Error> errors;
    Fields fields(json, "components", "a component", errors, Fields::Paths::field);
    const auto key = fields.text("key", Fields::Need::required), type = fields.text("type", Fields::Need::required);
    const Value* model = fields.find("rsm", Fields::Need::required);
    fields.close();
    if (!errors.empty()) return tl::unexpected(errors.front());
    const auto found = places_.find(*key);
    if (found == places_.end())
      return unexpected(ErrorCode::not_found, "no service of this key waits for a process", *key);
    const Place& place = found->second;
    if (*type != place.service.type)
      return unexpected(ErrorCode::type, "is of type `" + place.service.type + "` here, not `" + *type + "`", *key);
    auto service = rsm::read_service(*model, *key);
    if (!service) return tl::unexpected(service.error().front());
    if (rsm::write_service(*service) != rsm::write_service(*place.service.model))
      return unexpected(ErrorCode::conflict, "has another RSM here: another version of the program?", *key);
    if (std::ranges::find(places, &place) != places.end()) return taken(*key);
    if (!places.empty() && place.group != places.front()->group)
      return unexpected(ErrorCode::conflict, "belongs into another process", *key);
    places.push_back(&place);
  }
  return places;
}

// What the process says is read before the lock is taken: a thread that posts to a group does not wait for that.
Expected<Remotes::Claim> Remotes::claim(const Value& components, const Value& world,
                                        const std::vector<std::string>& groups) {
  Claim claim;
  ASSIGN_OR_RETURN(claim.places, find(components));
  if (const std::string& name = names_[claim.places.front()->group]; std::ranges::find(groups, name) == groups.end())
    return unexpected(ErrorCode::rights, "this account may not bring the group `" + name + '`',
                      claim.places.front()->service.key);
  if (!world.is_null()) {
    claim.remote_world = worlds_[claim.places.front()->group];
    if (!claim.remote_world) return unexpected(ErrorCode::not_found, "these services have no world here", "world");
    ASSIGN_OR_RETURN(claim.world, claim.remote_world->check(world));
  }
  const services::MutexLock lock(mutex_);
  for (const Place* each : claim.places)
    if (claimed_.contains(each->service.key)) return taken(each->service.key);
  if (claim.remote_world && !claimed_worlds_.insert(claim.remote_world).second) return taken("world");
  for (const Place* each : claim.places) claimed_.insert(each->service.key);
  return claim;
}

void Remotes::release(const std::vector<std::string>& keys, const RemoteWorld* world) {
  const services::MutexLock lock(mutex_);
  claimed_worlds_.erase(world);
  for (const std::string& key : keys) claimed_.erase(key);
}

void Remotes::post(std::size_t group, services::WorkQueue::Work work) {
  const services::MutexLock lock(mutex_);
  if (group < groups_.size()) groups_[group]->post(std::move(work));
}

}  // namespace race::remote
