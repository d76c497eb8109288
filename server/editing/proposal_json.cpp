#include "server/editing/proposal_json.h"

#include <string>

namespace race::server {

Dict proposal_json(const Proposal& proposal) {
  Dict json{{"id", std::to_string(proposal.id)},
            {"document", proposal.document},
            {"base_revision", proposal.base > 0 ? Value(proposal.base) : Value()},
            {"author", proposal.author},
            {"note", proposal.note},
            {"created", proposal.created_ms},
            {"status", std::string(shown_status(proposal))}};
  if (proposal.status == Proposal::Status::open) return json;
  json.set("decided_by", proposal.decided_by);
  json.set("decided", proposal.decided_ms);
  if (!proposal.reason.empty()) json.set("reason", proposal.reason);
  if (proposal.revision > 0) json.set("revision", proposal.revision);
  return json;
}

}  // namespace race::server
