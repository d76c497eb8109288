// Proposal: a change of a document that somebody proposes, and what has become of it. Who may change documents accepts
// it, which makes it a revision, or declines it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/value/expected.h"

namespace race::server {

struct Proposal {
  enum class Status { open, accepted, declined, withdrawn };

  std::int64_t id = 0;  // larger than those of all before it, also of a store that a backup has replaced
  std::string document = {};
  std::int64_t base = 0;  // the revision that it changes; 0: it is a new document
  std::string author = {};
  std::string note = {};  // why
  std::int64_t created_ms = 0;
  Status status = Status::open;
  std::string decided_by = {};
  std::string reason = {};  // why it was declined
  std::int64_t decided_ms = 0;
  std::int64_t revision = 0;  // that accepting it has made; 0: none
  std::int64_t bytes = 0;     // of its text
  std::int64_t current = 0;   // the last revision of the document when this was read; 0: there was none

  /// It is open, and cannot be accepted: somebody has changed the document since.
  bool is_outdated() const { return status == Status::open && base != current; }
  bool operator==(const Proposal&) const = default;
};

/// As the store has it: "open", "accepted", "declined", "withdrawn".
std::string_view name(Proposal::Status status);
/// As clients see it: the same, and "outdated".
std::string_view shown_status(const Proposal& proposal);

/// A proposal with the text of the document that it proposes, with ids, as files hold it.
struct ProposalText {
  Proposal proposal;
  std::string text;
};

struct ProposalDecision {
  Proposal::Status status = Proposal::Status::declined;  // none that is open
  std::string by = {};
  std::string reason = {};
  std::int64_t time_ms = 0;
  std::int64_t revision = 0;
};

/// Which ones are listed.
struct ProposalQuery {
  std::string document = {};  // empty: of all
  std::string status = {};    // as clients see it; empty: any
  std::int64_t after = 0;
  std::int64_t most = 100;
};

struct ProposalPage {
  std::vector<Proposal> proposals;   // in order of their ids
  std::vector<Error> damaged;        // `corrupt`, of one each
  std::optional<std::int64_t> next;  // id of the last one if there are more after it
};

/// Who an author is, without the tag of a page: `alice~3f` is alice.
std::string person_of(const std::string& author);

}  // namespace race::server
