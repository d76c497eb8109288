// Proposals: the changes of documents that were proposed, until somebody has decided about them, and the last of those
// that were decided. Who accepts one stores it with Documents::accept.
//
// Errors of all: `corrupt`: what is stored is damaged; `storage`, `io`.
//
// Threads: any; one at a time inside.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/value/expected.h"
#include "server/store/proposal.h"
#include "services/mutex.h"

namespace SQLite {
class Database;
}

namespace race::server {

class Proposals {
 public:
  static constexpr std::size_t kMaxNote = 2000;  // code points, of a note and of a reason

  /// Opens the store (DataFolder::store).
  static Expected<std::unique_ptr<Proposals>> open(const std::string& path);
  ~Proposals();

  /// Keeps a proposal as an open one, with an id of its own; durable when it returns. Requires a text that
  /// Documents::prepare has made. Errors: `too_large`: its author or note, or too many are open
  /// (proposal_rows.h).
  Expected<Proposal> add(Proposal proposal, const std::string& text) EXCLUDES(mutex_);
  /// `not_found`
  Expected<Proposal> find(std::int64_t id) EXCLUDES(mutex_);
  /// With its text. `not_found`
  Expected<ProposalText> read(std::int64_t id) EXCLUDES(mutex_);
  Expected<ProposalPage> list(const ProposalQuery& query) EXCLUDES(mutex_);
  /// All that nobody has decided about, outdated ones among them; those that are damaged are left out.
  Expected<std::vector<Proposal>> undecided() EXCLUDES(mutex_);
  /// It is declined or withdrawn. Errors: `not_found`; `conflict`: it was decided before; `too_large`: who decides, or
  /// the reason.
  Expected<Proposal> decide(std::int64_t id, const ProposalDecision& decision) EXCLUDES(mutex_);

 private:
  explicit Proposals(std::unique_ptr<SQLite::Database> file);
  services::Mutex mutex_;
  const std::unique_ptr<SQLite::Database> file_ PT_GUARDED_BY(mutex_);
};

}  // namespace race::server
