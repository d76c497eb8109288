#include "server/store/edit_between.h"

#include <string>
#include <utility>

#include "core/edit/difference.h"
#include "core/edit/history.h"
#include "core/rcm/document.h"
#include "server/store/document_text.h"

namespace race::server {
namespace {

std::optional<edit::Tree> editable(const std::string& text) {
  const auto read = read_document_or_draft(text);
  if (!read || !read->is_whole) return std::nullopt;
  auto tree = edit::Tree::read(read->document);
  if (!tree) return std::nullopt;
  return std::move(*tree);
}

}  // namespace

std::optional<RevisionEdit> edit_between(const RevisionText& before, const RevisionText& next) {
  auto from = editable(before.text);
  const auto to = editable(next.text);
  if (!from || !to) return std::nullopt;
  const auto difference = edit::difference(*from, *to);
  if (!difference) return std::nullopt;
  edit::History history(std::move(*from), static_cast<edit::Revision>(before.revision.number));
  const auto accepted = history.apply(next.revision.change.author, history.revision(), *difference);
  if (!accepted) return std::nullopt;
  const auto text = rcm::write_document_text(history.tree().document());
  if (!text || *text != next.text) return std::nullopt;
  return RevisionEdit{(*accepted)->edit};
}

}  // namespace race::server
