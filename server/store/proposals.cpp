#include "server/store/proposals.h"

#include <SQLiteCpp/Database.h>

#include <iterator>

#include "core/language/primitives/utf8.h"
#include "server/store/documents.h"
#include "server/store/proposal_rows.h"
#include "services/sqlite/file.h"
#include "services/sqlite/write_transaction.h"

namespace race::server {
namespace {

constexpr const char* kCannotReadProposals = "cannot read proposals";

Expected<void> check_words(const std::string& text, std::size_t most, const char* path) {
  if (language::utf8::length(text) <= most) return {};
  return unexpected(ErrorCode::too_large, "has more than " + std::to_string(most) + " characters", path);
}

Expected<void> check_words(const std::string& author, const std::string& words, const char* path) {
  if (auto fits = check_words(author, Documents::kMaxAuthor, "author"); !fits) return fits;
  return check_words(words, Proposals::kMaxNote, path);
}

}  // namespace

Proposals::Proposals(std::unique_ptr<SQLite::Database> file) : file_(std::move(file)) {}
Proposals::~Proposals() = default;

Expected<std::unique_ptr<Proposals>> Proposals::open(const std::string& path) try {
  return std::unique_ptr<Proposals>(new Proposals(sqlite::open(path)));
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot open the proposals"));
}

Expected<Proposal> Proposals::add(Proposal proposal, const std::string& text) try {
  if (auto fits = check_words(proposal.author, proposal.note, "note"); !fits)
    return tl::unexpected(std::move(fits).error());
  const services::MutexLock lock(mutex_);
  sqlite::WriteTransaction transaction(*file_);
  ASSIGN_OR_RETURN(Proposal added, add_proposal(*file_, std::move(proposal), text));
  transaction.commit();
  return added;
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot store a proposal"));
}

Expected<Proposal> Proposals::find(std::int64_t id) try {
  const services::MutexLock lock(mutex_);
  return find_proposal(*file_, id);
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, kCannotReadProposals));
}

Expected<ProposalText> Proposals::read(std::int64_t id) try {
  const services::MutexLock lock(mutex_);
  return read_proposal(*file_, id);
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, kCannotReadProposals));
}

Expected<ProposalPage> Proposals::list(const ProposalQuery& query) try {
  const services::MutexLock lock(mutex_);
  return list_proposal_rows(*file_, query);
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, kCannotReadProposals));
}

Expected<std::vector<Proposal>> Proposals::undecided() {
  std::vector<Proposal> all;
  for (const char* status : {"open", "outdated"}) {
    ASSIGN_OR_RETURN(ProposalPage page, list({.status = status, .most = kMostOpenProposals}));
    std::move(page.proposals.begin(), page.proposals.end(), std::back_inserter(all));
  }
  return all;
}

Expected<Proposal> Proposals::decide(std::int64_t id, const ProposalDecision& decision) try {
  if (auto fits = check_words(decision.by, decision.reason, "reason"); !fits)
    return tl::unexpected(std::move(fits).error());
  const services::MutexLock lock(mutex_);
  sqlite::WriteTransaction transaction(*file_);
  ASSIGN_OR_RETURN(Proposal decided, decide_proposal(*file_, id, decision));
  transaction.commit();
  return decided;
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot store a decision"));
}

}  // namespace race::server
