#include "services/remote/own_services.h"

#include <algorithm>
#include <utility>

#include "core/rsm/document.h"
#include "core/value/fields.h"
#include "core/value/json.h"

namespace race::remote {
namespace {

bool is_short_name(const std::string& text) { return is_name(text) && text.size() <= OwnServices::kKeyBytes; }

}  // namespace

tl::unexpected<Error> not_awaited(const std::string& key) {
  return unexpected(ErrorCode::not_found, "no service of this key waits for a process", key);
}

Expected<Offer> OwnServices::read(const std::string& key, const std::string& type, const Value& rsm) {
  const std::string most = std::to_string(kKeyBytes);
  if (!is_short_name(key))
    return unexpected(ErrorCode::name,
                      "a key has at most " + most + " letters, digits and `_`, and begins with none of the digits",
                      key);
  if (!is_short_name(type))
    return unexpected(ErrorCode::name,
                      "a type has at most " + most + " letters, digits and `_`, and begins with none of the digits",
                      key);
  if (std::ranges::find(kReserved, key) != kReserved.end()) return not_awaited(key);
  if (to_json(rsm).size() > kRsmBytes)
    return unexpected(ErrorCode::too_large, "an RSM has at most " + std::to_string(kRsmBytes) + " bytes of JSON", key);
  auto model = rsm::read_service(rsm, key);
  if (!model) return tl::unexpected(std::move(model.error().front()));
  if (model->operations.empty() && model->events.empty())
    return unexpected(ErrorCode::missing, "a service has an operation or an event", key);
  return Offer{key, type, std::make_shared<const rsm::Service>(std::move(*model))};
}

Expected<void> OwnServices::add(const std::vector<Offer>& offers, const std::string& account) {
  const auto is_new = [this](const Offer& offer) { return !keys_.contains(offer.key); };
  for (const Offer& offer : offers) {
    if (is_new(offer) && host_.has(offer.key)) return not_awaited(offer.key);
    if (!is_new(offer) && !account.empty() && keys_.at(offer.key) != account)
      return unexpected(ErrorCode::rights, "the processes of another account have brought this service", offer.key);
  }
  const auto more = static_cast<std::size_t>(std::ranges::count_if(offers, is_new));
  if (keys_.size() + more > kMost)
    return unexpected(ErrorCode::too_large,
                      "this server has known " + std::to_string(kMost) +
                          " services of processes of their own since it began, and knows no more",
                      std::ranges::find_if(offers, is_new)->key);
  for (const Offer& offer : offers) keys_.try_emplace(offer.key, account);
  return {};
}

RemoteComponent* OwnServices::host(const Offer& offer) {
  Hosted& hosted = hosted_[offer.key];
  if (!hosted.host) {
    hosted.host = &host_.declare(offer.key, offer.type, queue_);
  } else if (hosted.component && hosted.offer.type == offer.type && *hosted.offer.model == *offer.model) {
    return hosted.component;
  }
  auto component = std::make_unique<RemoteComponent>(offer.key, offer.model, *hosted.host);
  RemoteComponent* const described = component.get();
  host_.describe(offer.key, offer.type, std::move(component));
  hosted.component = described;
  hosted.offer = offer;
  return described;
}

}  // namespace race::remote
