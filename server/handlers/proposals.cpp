// GET /api/v1/proposals?document&status&after&limit, GET and DELETE /api/v1/proposals/{id}, POST
// /api/v1/documents/{name}/proposals, POST /api/v1/proposals/{id}/accept and decline: changes of documents that wait
// for somebody who may make them.
#include "server/store/proposals.h"

#include <algorithm>
#include <array>

#include "core/value/json.h"
#include "server/editing/proposal_json.h"
#include "server/editing/proposing.h"
#include "server/handlers/body.h"
#include "server/handlers/document_requests.h"
#include "server/handlers/query.h"
#include "server/wire/calendar.h"
#include "server/wire/errors.h"

namespace race::server {
namespace {

constexpr std::int64_t kMostProposalsListed = 100;
constexpr std::array<std::string_view, 5> kShownStatuses = {"open", "outdated", "accepted", "declined", "withdrawn"};

Expected<std::int64_t> proposal_id(const Request& request) {
  const std::string& text = request.parameters.at("id");
  if (const auto id = whole_number(text)) return *id;
  return unexpected(ErrorCode::not_found, "there is no proposal of this number", text);
}

/// With the document that it proposes.
Expected<Value> whole_json(Proposals& proposals, std::int64_t id) {
  ASSIGN_OR_RETURN(const ProposalText found, proposals.read(id));
  ASSIGN_OR_RETURN(Value document, parse_json(found.text));
  Dict json = proposal_json(found.proposal);
  json.set("proposed", std::move(document));
  return Value(std::move(json));
}

Handled answer_proposal(const Expected<Proposal>& proposal) {
  if (!proposal) return failed(proposal.error());
  return ok(proposal_json(*proposal));
}

struct ProposedChange {
  Proposal proposal;
  std::string text;  // of the document
};

ProposedChange read_proposed(Fields& fields) {
  ProposedChange out;
  const Value* document = fields.find("document", kRequired);
  if (document && document->is_dict())
    out.text = to_json(*document);
  else if (document)
    fields.violation(ErrorCode::type, "`document` must be an object", "document");
  const Value* revision = fields.find("revision");
  if (revision && !revision->is_null())
    out.proposal.base = read_revision_number(fields, Fields::Need::optional).value_or(0);
  out.proposal.note = fields.text("note").value_or("");
  return out;
}

Handled decide(const Request& request, Proposing& proposing, Proposal::Status status, std::string reason) {
  const auto id = proposal_id(request);
  if (!id) return failed(id.error());
  auto author = author_of(request);
  if (!author) return failed(std::move(author).error());
  return answer_proposal(proposing.decide(*id, {status, std::move(*author), std::move(reason), now_ms()}));
}

}  // namespace

Handled propose_document(const Request& request, Proposals& proposals, Proposing& proposing) {
  auto body = read_body(request.body, read_proposed);
  if (!body) return tl::unexpected(std::move(body).error());
  auto author = author_of(request);
  if (!author) return failed(std::move(author).error());
  Proposal proposal = std::move(body->proposal);
  proposal.document = request.parameters.at("name");
  proposal.author = std::move(*author);
  proposal.created_ms = now_ms();
  const auto added = proposing.propose(std::move(proposal), body->text);
  if (!added) return tl::unexpected(added.error());
  auto json = whole_json(proposals, added->id);
  if (!json) return failed(std::move(json).error());
  return created(std::move(*json), "/api/v1/proposals/" + std::to_string(added->id));
}

Handled list_proposals(const Request& request, Proposals& proposals) {
  const auto after = query_number(request, "after", {0});
  const auto limit = query_number(request, "limit", {1, kMostProposalsListed});
  if (!after) return failed(after.error());
  if (!limit) return failed(limit.error());
  const std::string status = query_text(request, "status");
  if (!status.empty() && std::ranges::find(kShownStatuses, status) == kShownStatuses.end())
    return failed({ErrorCode::out_of_range, "must be open, outdated, accepted, declined or withdrawn", "status"});
  const auto page = proposals.list(
      {query_text(request, "document"), status, after->value_or(0), limit->value_or(kMostProposalsListed)});
  if (!page) return failed(page.error());
  List list;
  for (const Proposal& each : page->proposals) list.emplace_back(proposal_json(each));
  Dict json{{"proposals", std::move(list)}};
  if (page->next) json.set("next", std::to_string(*page->next));
  if (!page->damaged.empty()) json.set("damaged", error_list(page->damaged));
  return ok(std::move(json));
}

Handled get_proposal(const Request& request, Proposals& proposals) {
  const auto id = proposal_id(request);
  if (!id) return failed(id.error());
  auto json = whole_json(proposals, *id);
  if (!json) return failed(std::move(json).error());
  return ok(std::move(*json));
}

Handled accept_proposal(const Request& request, Proposing& proposing) {
  const auto id = proposal_id(request);
  if (!id) return failed(id.error());
  const auto author = author_of(request);
  if (!author) return failed(author.error());
  const auto accepted = proposing.accept(*id, *author, now_ms());
  if (!accepted) return tl::unexpected(accepted.error());
  return ok(proposal_json(*accepted));
}

Handled decline_proposal(const Request& request, Proposing& proposing) {
  std::string text = request.body.empty() ? "{}" : request.body;
  auto reason = read_body(text, [](Fields& fields) { return fields.text("reason").value_or(""); });
  if (!reason) return tl::unexpected(std::move(reason).error());
  return decide(request, proposing, Proposal::Status::declined, std::move(*reason));
}

// Their author takes it back, or somebody who could decline it.
Handled withdraw_proposal(const Request& request, Proposals& proposals, Proposing& proposing) {
  const auto id = proposal_id(request);
  if (!id) return failed(id.error());
  const auto found = proposals.find(*id);
  if (!found) return failed(found.error());
  const Identity& who = request.identity;
  const bool is_own = who.account.empty() || who.account == person_of(found->author);
  if (!is_own && !has_right(who.role, Right::developer))
    return failed({ErrorCode::rights, "somebody else has proposed it", std::to_string(*id)});
  return decide(request, proposing, Proposal::Status::withdrawn, "");
}

}  // namespace race::server
