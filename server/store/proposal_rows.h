// The rows of the table `proposal` (schema.h), each held against its digest: one that is damaged is named, never used.
//
// Threads: those of the connection. All may throw SQLite::Exception.
#pragma once

#include <cstdint>
#include <string>

#include "core/value/expected.h"
#include "server/store/proposal.h"

namespace SQLite {
class Database;
}

namespace race::server {

inline constexpr std::int64_t kMebibyte = 1024 * 1024;
/// How many are open at once, and of how many bytes together: in all, and of one person.
inline constexpr std::int64_t kMostOpenProposals = 100, kMostOpenBytes = 64 * kMebibyte;
inline constexpr std::int64_t kMostProposalsOfPerson = 20, kMostBytesOfPerson = 32 * kMebibyte;
/// How many of those that were decided are kept, and of how many bytes together: the last ones, and the very last one
/// in any case.
inline constexpr std::int64_t kMostDecidedProposals = 200, kMostDecidedBytes = 64 * kMebibyte;

/// Without its text. Errors: `not_found`, `corrupt`.
Expected<Proposal> find_proposal(SQLite::Database& file, std::int64_t id);
/// Errors: `not_found`, `corrupt`.
Expected<ProposalText> read_proposal(SQLite::Database& file, std::int64_t id);
/// Reads no texts.
ProposalPage list_proposal_rows(SQLite::Database& file, const ProposalQuery& query);
/// Adds an open one, with the next id. Requires a transaction. Error `too_large`: too many are open, or too large ones.
Expected<Proposal> add_proposal(SQLite::Database& file, Proposal proposal, const std::string& text);
/// Requires a transaction. Beyond the bounds, the oldest decisions go. Errors: `not_found`, `corrupt`; `conflict`: it
/// was decided before.
Expected<Proposal> decide_proposal(SQLite::Database& file, std::int64_t id, const ProposalDecision& decision);

/// Error `conflict`: it was decided before.
Expected<void> check_open(const Proposal& proposal);

}  // namespace race::server
