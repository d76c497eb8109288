// Proposing: everything that changes proposals while the server runs, so that the channel `proposals` tells of each
// change of an open one, in order, once it is durable; also that the document has changed, or is gone.
//
// Threads: any. What is told waits for no disk.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/value/expected.h"
#include "server/editing/document_watcher.h"
#include "server/editing/editing.h"
#include "server/store/documents.h"
#include "server/store/proposals.h"
#include "server/stream/hub.h"
#include "services/mutex.h"

namespace race::server {

class Proposing final : public DocumentWatcher {
 public:
  /// All outlive this, and this outlives what changes documents.
  Proposing(Proposals& proposals, Documents& documents, Editing& editing, Hub& hub)
      : proposals_(proposals), documents_(documents), editing_(editing), hub_(hub) {}

  // Errors of all: those of Proposals.

  /// Keeps what somebody proposes: a document with this text, of the name, author, note, base and time of `proposal`.
  /// Errors: those of Documents::prepare.
  Checked<Proposal> propose(Proposal proposal, std::string_view text) EXCLUDES(order_, mutex_);
  /// Makes it the next revision of its document. Errors: those of Documents::accept, and of Editing.
  Checked<Proposal> accept(std::int64_t id, const std::string& author, std::int64_t now_ms) EXCLUDES(order_, mutex_);
  /// Declines or withdraws it. Errors: those of Proposals::decide.
  Expected<Proposal> decide(std::int64_t id, const ProposalDecision& decision) EXCLUDES(order_, mutex_);

  /// Publishes those that nobody has decided about.
  void publish_snapshot() EXCLUDES(mutex_);
  /// Reads all of them, at the beginning and when the store has become another one; subscribers get a snapshot.
  Expected<void> reload() EXCLUDES(order_, mutex_);

  void document_changed(const std::string& name, std::int64_t revision, bool has_violations) override
      EXCLUDES(order_, mutex_);
  void document_removed(const std::string& name) override EXCLUDES(order_, mutex_);

 private:
  /// Those that become outdated or are outdated no more as the document has this last revision (0: it is gone).
  std::vector<std::int64_t> turned_by(const std::string& name, std::int64_t revision) REQUIRES(order_) EXCLUDES(mutex_);
  void follow(const std::string& name, std::int64_t revision) EXCLUDES(order_, mutex_);
  void tell(std::int64_t id) EXCLUDES(order_, mutex_);
  void read_and_tell(std::int64_t id) REQUIRES(order_) EXCLUDES(mutex_);

  Proposals& proposals_;
  Documents& documents_;
  Editing& editing_;
  Hub& hub_;
  services::Mutex order_;  // who holds it reads the store and tells: so it is told in the order in which it happened
  services::Mutex mutex_;  // for moments
  std::map<std::int64_t, Proposal> undecided_ GUARDED_BY(mutex_);
};

}  // namespace race::server
