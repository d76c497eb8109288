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
  declare(make_group(std::move(name), world), services);
}

void Remotes::add_own(const std::vector<RemoteService>& expected, std::optional<std::set<std::string>> accounts) {
  const services::MutexLock lock(mutex_);
  own_group_ = make_group(std::string(kOwnGroup), nullptr);
  own_accounts_ = std::move(accounts);
  own_ = std::make_unique<OwnServices>(host_, *groups_[own_group_]);
  declare(own_group_, expected);
}

std::size_t Remotes::make_group(std::string name, RemoteWorld* world) {
  names_.push_back(std::move(name));
  worlds_.push_back(world);
  groups_.push_back(std::make_unique<services::WorkThread>("processes", kShare));
  groups_.back()->post(services::shorten_time_slice);
  return groups_.size() - 1;
}

void Remotes::declare(std::size_t group, const std::vector<RemoteService>& services) {
  for (const RemoteService& service : services) {
    services::ServiceHost& host = host_.declare(service.key, service.type, *groups_[group]);
    // It outlives all, so it is held by nobody.
    const std::shared_ptr<const rsm::Service> model(std::shared_ptr<const void>(), service.model);
    auto component = std::make_unique<RemoteComponent>(service.key, model, host, service.host_functions);
    places_.emplace(service.key, Place{service, group, component.get()});
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

// What a process brings, claimed or not.
Expected<Remotes::Claim> Remotes::find(const Value& components) const {
  if (components.as_list().empty()) return unexpected(ErrorCode::missing, "there is no component", "components");
  const std::size_t most = std::max<std::size_t>(places_.size() + (own_ ? OwnServices::kMost : 0), 1);
  if (components.as_list().size() > most)
    return unexpected(ErrorCode::too_large, "a process brings at most " + std::to_string(most) + " services here",
                      "components");
  Claim claim;
  for (const Value& json : components.as_list()) {
    std::vector<Error> errors;
    Fields fields(json, "components", "a component", errors, Fields::Paths::field);
    const auto key = fields.text("key", Fields::Need::required), type = fields.text("type", Fields::Need::required);
    const Value* model = fields.find("rsm", Fields::Need::required);
    fields.close();
    if (!errors.empty()) return tl::unexpected(errors.front());
    ASSIGN_OR_RETURN(const std::size_t group, find(*key, *type, *model, claim));
    if (std::ranges::find(claim.keys, *key) != claim.keys.end()) return taken(*key);
    if (!claim.keys.empty() && group != claim.group)
      return unexpected(ErrorCode::conflict, "belongs into another process", *key);
    claim.group = group;
    claim.keys.push_back(*key);
  }
  return claim;
}

// Adds one service to the claim; the group of that.
Expected<std::size_t> Remotes::find(const std::string& key, const std::string& type, const Value& rsm,
                                    Claim& claim) const {
  const auto found = places_.find(key);
  if (found == places_.end()) {
    if (!own_) return not_awaited(key);
    ASSIGN_OR_RETURN(Offer offer, OwnServices::read(key, type, rsm));
    claim.offers.push_back(std::move(offer));
    return own_group_;
  }
  const Place& place = found->second;
  if (type != place.service.type)
    return unexpected(ErrorCode::type, "is of type `" + place.service.type + "` here, not `" + type + "`", key);
  auto service = rsm::read_service(rsm, key);
  if (!service) return tl::unexpected(service.error().front());
  if (rsm::write_service(*service) != rsm::write_service(*place.service.model))
    return unexpected(ErrorCode::conflict, "has another RSM here: another version of the program?", key);
  claim.places.push_back(&place);
  return place.group;
}

Expected<void> Remotes::check_rights(const Claim& claim, const Owner& owner) const {
  const std::string& name = names_[claim.group];
  if (std::ranges::find(owner.groups, name) == owner.groups.end())
    return unexpected(ErrorCode::rights, "this account may not bring the group `" + name + '`', claim.keys.front());
  const bool is_listed = !own_accounts_ || owner.account.empty() || own_accounts_->contains(owner.account);
  if (own_ && claim.group == own_group_ && !is_listed)
    return unexpected(ErrorCode::rights, "the cell does not let this account bring services", claim.keys.front());
  return {};
}

// What the process says is read before the lock is taken: a thread that posts to a group does not wait for that.
Expected<Remotes::Claim> Remotes::claim(const Value& components, const Value& world, const Owner& owner) {
  ASSIGN_OR_RETURN(Claim claim, find(components));
  if (auto allowed = check_rights(claim, owner); !allowed) return tl::unexpected(std::move(allowed).error());
  if (!world.is_null()) {
    claim.remote_world = worlds_[claim.group];
    if (!claim.remote_world) return unexpected(ErrorCode::not_found, "these services have no world here", "world");
    ASSIGN_OR_RETURN(claim.world, claim.remote_world->check(world));
  }
  const services::MutexLock lock(mutex_);
  for (const std::string& key : claim.keys)
    if (claimed_.contains(key)) return taken(key);
  if (!claim.offers.empty())
    if (auto added = own_->add(claim.offers, owner.account); !added) return tl::unexpected(std::move(added).error());
  if (claim.remote_world && !claimed_worlds_.insert(claim.remote_world).second) return taken("world");
  claimed_.insert(claim.keys.begin(), claim.keys.end());
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
