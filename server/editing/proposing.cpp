#include "server/editing/proposing.h"

#include <utility>

#include "core/language/primitives/utf8.h"
#include "server/editing/proposal_json.h"
#include "server/store/proposal_rows.h"
#include "server/wire/channel_names.h"

namespace race::server {
namespace {

tl::unexpected<std::vector<Error>> refused_proposal(Error error) {
  return tl::unexpected(std::vector<Error>{std::move(error)});
}

/// Why it cannot be accepted, if that is known already.
Expected<void> check_acceptable(const Proposal& proposal) {
  if (auto open = check_open(proposal); !open) return open;
  if (!proposal.is_outdated()) return {};
  const std::string now = proposal.current == 0 ? "there is no such document any more"
                                                : "the last revision is " + std::to_string(proposal.current);
  return unexpected(ErrorCode::conflict,
                    "the document has changed since it was proposed: " + now + "; it has to be proposed anew",
                    proposal.document);
}

/// The message of the revision: the note, as far as there is room for it.
std::string message_of(const std::string& note) {
  return note.substr(0, language::utf8::offset(note, Documents::kMaxMessage));
}

Value channel_json(List proposals) {
  Value data(Dict{{"proposals", std::move(proposals)}});
  return std::move(data.freeze());
}

}  // namespace

Checked<Proposal> Proposing::propose(Proposal proposal, std::string_view text) {
  Documents::Put options;
  options.is_new = proposal.base == 0;
  if (proposal.base > 0) options.seen = proposal.base;
  const auto prepared = documents_.prepare(proposal.document, text, options);
  if (!prepared) return tl::unexpected(prepared.error());
  auto added = proposals_.add(std::move(proposal), *prepared);
  if (!added) return refused_proposal(std::move(added).error());
  tell(added->id);
  return std::move(*added);
}

Checked<Proposal> Proposing::accept(std::int64_t id, const std::string& author, std::int64_t now_ms) {
  const auto found = proposals_.find(id);
  if (!found) return refused_proposal(found.error());
  if (auto acceptable = check_acceptable(*found); !acceptable) {
    tell(id);
    return refused_proposal(std::move(acceptable).error());
  }
  const Change change{author, message_of(found->note), now_ms};
  const auto stored = editing_.accept(found->document, id, change);
  tell(id);
  if (!stored) return tl::unexpected(stored.error());
  auto accepted = proposals_.find(id);
  if (!accepted) return refused_proposal(std::move(accepted).error());
  return std::move(*accepted);
}

Expected<Proposal> Proposing::decide(std::int64_t id, const ProposalDecision& decision) {
  auto decided = proposals_.decide(id, decision);
  tell(id);  // what was refused because the disk failed may have been stored all the same
  return decided;
}

void Proposing::publish_snapshot() {
  const services::MutexLock lock(mutex_);
  List all;
  for (const auto& [id, proposal] : undecided_) all.emplace_back(proposal_json(proposal));
  hub_.publish_snapshot(std::string(kProposalsChannel), channel_json(std::move(all)));
}

Expected<void> Proposing::reload() {
  const services::MutexLock order(order_);
  ASSIGN_OR_RETURN(const std::vector<Proposal> all, proposals_.undecided());
  const services::MutexLock lock(mutex_);
  undecided_.clear();
  for (const Proposal& each : all) undecided_.emplace(each.id, each);
  hub_.restart(std::string(kProposalsChannel));
  return {};
}

void Proposing::document_changed(const std::string& name, std::int64_t revision, bool) { follow(name, revision); }

void Proposing::document_removed(const std::string& name) { follow(name, 0); }

void Proposing::follow(const std::string& name, std::int64_t revision) {
  const services::MutexLock order(order_);
  for (const std::int64_t id : turned_by(name, revision)) read_and_tell(id);
}

std::vector<std::int64_t> Proposing::turned_by(const std::string& name, std::int64_t revision) {
  const services::MutexLock lock(mutex_);
  std::vector<std::int64_t> turned;
  for (auto& [id, proposal] : undecided_) {
    if (proposal.document != name) continue;
    const bool was_outdated = proposal.is_outdated();
    proposal.current = revision;
    if (proposal.is_outdated() != was_outdated) turned.push_back(id);
  }
  return turned;
}

void Proposing::tell(std::int64_t id) {
  const services::MutexLock order(order_);
  read_and_tell(id);
}

// What cannot be read now stays as it was told; who subscribes later is told the same.
void Proposing::read_and_tell(std::int64_t id) {
  auto found = proposals_.find(id);
  if (!found) return;
  const services::MutexLock lock(mutex_);
  Value data = channel_json({Value(proposal_json(*found))});
  if (found->status == Proposal::Status::open)
    undecided_[id] = std::move(*found);
  else if (undecided_.erase(id) == 0)
    return;  // that it is decided was told as its document changed
  hub_.publish_delta(std::string(kProposalsChannel), std::move(data));
}

}  // namespace race::server
