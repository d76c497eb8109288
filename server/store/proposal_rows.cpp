#include "server/store/proposal_rows.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <algorithm>
#include <array>

#include "server/store/digest_column.h"

namespace race::server {
namespace {

constexpr std::array kStatuses = {Proposal::Status::open, Proposal::Status::accepted, Proposal::Status::declined,
                                  Proposal::Status::withdrawn};

// The last revision of the document.
constexpr std::string_view kCurrent = "coalesce((SELECT last FROM document WHERE name = proposal.document), 0)";

// Columns of select_proposals(), and the one that may follow them.
constexpr int kTextDigestColumn = 12, kDigestColumn = 13, kCurrentColumn = 14, kTextColumn = 15;

// Of all columns but `text`, and of what the document is now.
std::string select_proposals() {
  return "SELECT id, document, base, author, note, created, status, decided_by, reason, decided, revision, bytes,"
         " text_digest, digest, " +
         std::string(kCurrent);
}

sqlite::Digest digest_of(const Proposal& proposal, std::string_view text_digest) {
  return sqlite::sha256_of({"proposal", std::to_string(proposal.id), proposal.document, std::to_string(proposal.base),
                            proposal.author, proposal.note, std::to_string(proposal.created_ms), name(proposal.status),
                            proposal.decided_by, proposal.reason, std::to_string(proposal.decided_ms),
                            std::to_string(proposal.revision), std::to_string(proposal.bytes), text_digest});
}

tl::unexpected<Error> damaged_proposal(std::int64_t id) {
  const std::string text = std::to_string(id);
  return unexpected(ErrorCode::corrupt, "the proposal " + text + " is damaged", "proposals/" + text);
}

tl::unexpected<Error> no_proposal(std::int64_t id) {
  return unexpected(ErrorCode::not_found, "there is no proposal of this number", std::to_string(id));
}

/// Of select_proposals().
Expected<Proposal> read_proposal_row(SQLite::Statement& row) {
  const auto text = [&](int column) { return row.getColumn(column).getString(); };
  const auto number = [&](int column) { return row.getColumn(column).getInt64(); };
  Proposal proposal{.id = number(0), .document = text(1), .base = number(2), .author = text(3), .note = text(4)};
  proposal.created_ms = number(5);
  proposal.decided_by = text(7);
  proposal.reason = text(8);
  proposal.decided_ms = number(9);
  proposal.revision = number(10);
  proposal.bytes = number(11);
  proposal.current = number(kCurrentColumn);
  const std::string status = text(6);
  const auto known =
      std::ranges::find(kStatuses, status, [](Proposal::Status each) { return std::string(name(each)); });
  if (known == kStatuses.end()) return damaged_proposal(proposal.id);
  proposal.status = *known;
  if (digest_in(row, kDigestColumn) != digest_of(proposal, text(kTextDigestColumn)))
    return damaged_proposal(proposal.id);
  return proposal;
}

struct OpenProposals {
  std::int64_t count = 0, bytes = 0;
};

/// With one more, of so many bytes.
OpenProposals with_one_more(SQLite::Statement& select, std::int64_t bytes) {
  select.executeStep();
  return {select.getColumn(0).getInt64() + 1, select.getColumn(1).getInt64() + bytes};
}

OpenProposals open_with(SQLite::Database& file, std::int64_t bytes) {
  SQLite::Statement select(file, "SELECT count(*), coalesce(sum(bytes), 0) FROM proposal WHERE status = 'open'");
  return with_one_more(select, bytes);
}

OpenProposals open_of_with(SQLite::Database& file, const std::string& person, std::int64_t bytes) {
  SQLite::Statement select(file,
                           "SELECT count(*), coalesce(sum(bytes), 0) FROM proposal WHERE status = 'open' AND"
                           " (author = ?1 OR substr(author, 1, length(?1) + 1) = ?1 || '~')");
  select.bind(1, person);
  return with_one_more(select, bytes);
}

/// `whose`: of all, if it is empty.
Expected<void> check_room(const OpenProposals& open, const OpenProposals& most, const std::string& whose,
                          const std::string& path) {
  if (open.count > most.count)
    return unexpected(ErrorCode::too_large,
                      "there are already " + std::to_string(most.count) + " open proposals" + whose +
                          ": decide about some, or withdraw some",
                      path);
  if (open.bytes > most.bytes)
    return unexpected(ErrorCode::too_large,
                      "with this one, the documents of the open proposals" + whose + " would have more than " +
                          std::to_string(most.bytes / kMebibyte) + " MiB",
                      path);
  return {};
}

// The time, so that none of a store that a backup has replaced has it.
std::int64_t next_id(SQLite::Database& file, std::int64_t now_ms) {
  return std::max(now_ms, file.execAndGet("SELECT coalesce(max(id), 0) + 1 FROM proposal").getInt64());
}

void insert_proposal(SQLite::Database& file, const Proposal& proposal, const std::string& text) {
  const sqlite::Digest text_digest = sqlite::sha256(text);
  SQLite::Statement insert(file,
                           "INSERT INTO proposal (id, document, base, author, note, created, status, decided_by,"
                           " reason, decided, revision, bytes, text_digest, digest, text)"
                           " VALUES (?, ?, ?, ?, ?, ?, ?, '', '', 0, 0, ?, ?, ?, ?)");
  insert.bind(1, proposal.id);
  insert.bind(2, proposal.document);
  insert.bind(3, proposal.base);
  insert.bind(4, proposal.author);
  insert.bind(5, proposal.note);
  insert.bind(6, proposal.created_ms);
  insert.bind(7, std::string(name(proposal.status)));
  insert.bind(8, proposal.bytes);
  bind_digest(insert, 9, text_digest);
  bind_digest(insert, 10, digest_of(proposal, sqlite::bytes(text_digest)));
  insert.bind(11, text);
  insert.exec();
}

/// But for `last`, which was decided now: also if the clock says that others were decided later.
void forget_oldest_decisions(SQLite::Database& file, std::int64_t last) {
  SQLite::Statement forget(file,
                           "DELETE FROM proposal WHERE id <> ?1 AND id IN (SELECT id FROM (SELECT id,"
                           " row_number() OVER newer AS count, sum(bytes) OVER newer AS bytes FROM proposal"
                           " WHERE status <> 'open' WINDOW newer AS (ORDER BY decided DESC, id DESC))"
                           " WHERE count > ?2 OR bytes > ?3)");
  forget.bind(1, last);
  forget.bind(2, kMostDecidedProposals);
  forget.bind(3, kMostDecidedBytes);
  forget.exec();
}

}  // namespace

std::string_view name(Proposal::Status status) {
  switch (status) {
    case Proposal::Status::open:
      return "open";
    case Proposal::Status::accepted:
      return "accepted";
    case Proposal::Status::declined:
      return "declined";
    case Proposal::Status::withdrawn:
      return "withdrawn";
  }
  return "";
}

std::string_view shown_status(const Proposal& proposal) {
  return proposal.is_outdated() ? "outdated" : name(proposal.status);
}

std::string person_of(const std::string& author) { return author.substr(0, author.find('~')); }

Expected<void> check_open(const Proposal& proposal) {
  if (proposal.status == Proposal::Status::open) return {};
  return unexpected(ErrorCode::conflict, "it is " + std::string(name(proposal.status)) + " already",
                    std::to_string(proposal.id));
}

Expected<Proposal> find_proposal(SQLite::Database& file, std::int64_t id) {
  SQLite::Statement select(file, select_proposals() + " FROM proposal WHERE id = ?");
  select.bind(1, id);
  if (!select.executeStep()) return no_proposal(id);
  return read_proposal_row(select);
}

Expected<ProposalText> read_proposal(SQLite::Database& file, std::int64_t id) {
  SQLite::Statement select(file, select_proposals() + ", text FROM proposal WHERE id = ?");
  select.bind(1, id);
  if (!select.executeStep()) return no_proposal(id);
  ASSIGN_OR_RETURN(Proposal proposal, read_proposal_row(select));
  ProposalText out{std::move(proposal), select.getColumn(kTextColumn).getString()};
  if (digest_in(select, kTextDigestColumn) != sqlite::sha256(out.text)) return damaged_proposal(id);
  return out;
}

ProposalPage list_proposal_rows(SQLite::Database& file, const ProposalQuery& query) {
  SQLite::Statement select(file, select_proposals() +
                                     " FROM proposal WHERE id > ?1 AND (?2 = '' OR document = ?2) AND"
                                     " (?3 = '' OR CASE WHEN status = 'open' AND base <> " +
                                     std::string(kCurrent) +
                                     " THEN 'outdated' ELSE status END = ?3)"
                                     " ORDER BY id LIMIT ?4");
  select.bind(1, query.after);
  select.bind(2, query.document);
  select.bind(3, query.status);
  select.bind(4, query.most + 1);
  ProposalPage page;
  std::int64_t last = 0;
  for (std::int64_t i = 0; select.executeStep(); ++i) {
    if (i == query.most) {
      page.next = last;
      break;
    }
    last = select.getColumn(0).getInt64();
    if (auto proposal = read_proposal_row(select))
      page.proposals.push_back(std::move(*proposal));
    else
      page.damaged.push_back(std::move(proposal).error());
  }
  return page;
}

Expected<Proposal> add_proposal(SQLite::Database& file, Proposal proposal, const std::string& text) {
  proposal.bytes = static_cast<std::int64_t>(text.size());
  const OpenProposals all = open_with(file, proposal.bytes);
  const OpenProposals own = open_of_with(file, person_of(proposal.author), proposal.bytes);
  if (auto fits = check_room(all, {kMostOpenProposals, kMostOpenBytes}, "", ""); !fits)
    return tl::unexpected(std::move(fits).error());
  if (auto fits = check_room(own, {kMostProposalsOfPerson, kMostBytesOfPerson}, " of this author", "author"); !fits)
    return tl::unexpected(std::move(fits).error());
  proposal.id = next_id(file, proposal.created_ms);
  proposal.status = Proposal::Status::open;
  insert_proposal(file, proposal, text);
  return find_proposal(file, proposal.id);
}

Expected<Proposal> decide_proposal(SQLite::Database& file, std::int64_t id, const ProposalDecision& decision) {
  SQLite::Statement select(file, select_proposals() + " FROM proposal WHERE id = ?");
  select.bind(1, id);
  if (!select.executeStep()) return no_proposal(id);
  ASSIGN_OR_RETURN(Proposal proposal, read_proposal_row(select));
  const std::string text_digest = select.getColumn(kTextDigestColumn).getString();
  select.reset();
  if (auto open = check_open(proposal); !open) return tl::unexpected(std::move(open).error());
  proposal.status = decision.status;
  proposal.decided_by = decision.by;
  proposal.reason = decision.reason;
  proposal.decided_ms = decision.time_ms;
  proposal.revision = decision.revision;
  SQLite::Statement update(file,
                           "UPDATE proposal SET status = ?, decided_by = ?, reason = ?, decided = ?, revision = ?,"
                           " digest = ? WHERE id = ?");
  update.bind(1, std::string(name(proposal.status)));
  update.bind(2, proposal.decided_by);
  update.bind(3, proposal.reason);
  update.bind(4, proposal.decided_ms);
  update.bind(5, proposal.revision);
  bind_digest(update, 6, digest_of(proposal, text_digest));
  update.bind(7, id);
  update.exec();
  forget_oldest_decisions(file, id);
  return proposal;
}

}  // namespace race::server
