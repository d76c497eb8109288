#include "server/store/revision_text.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include "core/edit/apply.h"
#include "core/rcm/document.h"
#include "core/value/json.h"
#include "server/store/digest_column.h"
#include "server/store/document_text.h"
#include "services/sqlite/digest.h"

namespace race::server {
namespace {

// An edit may nest what it inserts a little deeper than the document does, and set a field several times.
constexpr JsonLimits kLimits{.depth = JsonLimits{}.depth + 8, .bytes = 4 * JsonLimits{}.bytes};

struct Link {
  std::int64_t depth = 0;  // edits back to a whole text; 0: that of this revision is whole
  std::string request, edit;
};

sqlite::Digest digest_of(const std::string& document, std::int64_t number, const Link& link) {
  return sqlite::sha256_of({document, std::to_string(number), std::to_string(link.depth), link.request, link.edit});
}

Expected<Link> find_link(SQLite::Database& file, const std::string& document, std::int64_t number) {
  SQLite::Statement select(file,
                           "SELECT depth, request, edit, digest FROM revision_edit WHERE document = ? AND number = ?");
  select.bind(1, document);
  select.bind(2, number);
  if (!select.executeStep()) return damaged_revision(document, number, "lost");
  Link link{select.getColumn(0).getInt64(), select.getColumn(1), select.getColumn(2)};
  if (digest_of(document, number, link) != digest_in(select, 3)) return damaged_revision(document, number, "damaged");
  return link;
}

bool has_whole_text(SQLite::Database& file, const std::string& document, std::int64_t number) {
  SQLite::Statement select(file, "SELECT text <> '' FROM revision WHERE document = ? AND number = ?");
  select.bind(1, document);
  select.bind(2, number);
  return select.executeStep() && select.getColumn(0).getInt() != 0;
}

Expected<edit::Edit> parse(const Link& link, const std::string& document, std::int64_t number) {
  const auto json = parse_json(link.edit, kLimits);
  if (!json) return damaged_revision(document, number, "damaged");
  auto edit = edit::read_edit(*json);
  if (!edit) return damaged_revision(document, number, "damaged");
  return std::move(*edit);
}

}  // namespace

bool add_edit(SQLite::Database& file, const RevisionText& next, const RevisionEdit& edit) {
  const auto& [document, number, change, origin, errors, doc] = next.revision;
  Link link{0, edit.request, to_json(edit::write_edit(edit.edit))};
  // A text that is derived needs a link before it that is sound, or a whole text.
  const auto before = find_link(file, document, number - 1);
  const bool has_base = before || has_whole_text(file, document, number - 1);
  const std::int64_t depth = (before ? before->depth : 0) + 1;
  const bool is_derived = has_base && link.edit.size() < next.text.size() && depth <= kLongestChain;
  if (is_derived) link.depth = depth;
  SQLite::Statement insert(file, "INSERT INTO revision_edit VALUES (?, ?, ?, ?, ?, ?)");
  insert.bind(1, document);
  insert.bind(2, number);
  insert.bind(3, link.depth);
  insert.bind(4, link.request);
  insert.bind(5, link.edit);
  bind_digest(insert, 6, digest_of(document, number, link));
  insert.exec();
  return is_derived;
}

Expected<std::int64_t> chain_depth(SQLite::Database& file, const std::string& document, std::int64_t number) {
  ASSIGN_OR_RETURN(const Link link, find_link(file, document, number));
  if (link.depth < 1 || link.depth > kLongestChain) return damaged_revision(document, number, "damaged");
  return link.depth;
}

Expected<std::string> text_after(SQLite::Database& file, const std::string& document, RevisionRange links,
                                 std::string_view base) {
  const auto text = read_document_or_draft(base);
  if (!text || !text->is_whole) return damaged_revision(document, links.first - 1, "damaged");
  auto tree = edit::Tree::read(text->document);
  if (!tree) return damaged_revision(document, links.first - 1, "damaged");
  for (std::int64_t number = links.first; number <= links.last; ++number) {
    ASSIGN_OR_RETURN(const Link link, find_link(file, document, number));
    if (link.depth != number - links.first + 1) return damaged_revision(document, number, "damaged");
    ASSIGN_OR_RETURN(const edit::Edit edit, parse(link, document, number));
    if (!edit::apply(*tree, edit)) return damaged_revision(document, number, "damaged");
  }
  auto after = rcm::write_document_text(tree->document());
  if (!after) return damaged_revision(document, links.last, "damaged");
  return std::move(*after);
}

std::vector<EditToken> list_tokens(SQLite::Database& file, const std::string& document, std::int64_t first,
                                   std::int64_t most) {
  SQLite::Statement select(
      file,
      "SELECT revision.author, last.request, number FROM (SELECT number, request FROM"
      " revision_edit WHERE document = ?1 AND number >= ?3 ORDER BY number DESC LIMIT ?2) AS last JOIN revision"
      " USING (number) WHERE revision.document = ?1 AND last.request <> '' ORDER BY number");
  select.bind(1, document);
  select.bind(2, most);
  select.bind(3, first);
  std::vector<EditToken> tokens;
  while (select.executeStep())
    tokens.push_back({select.getColumn(0), select.getColumn(1), select.getColumn(2).getInt64()});
  return tokens;
}

Expected<RevisionEdit> find_edit(SQLite::Database& file, const std::string& document, std::int64_t number) {
  ASSIGN_OR_RETURN(Link link, find_link(file, document, number));
  ASSIGN_OR_RETURN(edit::Edit edit, parse(link, document, number));
  return RevisionEdit{std::move(edit), std::move(link.request)};
}

}  // namespace race::server
