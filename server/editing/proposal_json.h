// Proposals as clients see them. Pure.
#pragma once

#include "core/value/value.h"
#include "server/store/proposal.h"

namespace race::server {

/// schemas/proposal.json, without the document.
Dict proposal_json(const Proposal& proposal);

}  // namespace race::server
