// Documents with readable ids, and edits of them; for tests.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "core/edit/apply.h"
#include "core/edit/tree.h"
#include "core/rcm/document.h"
#include "core/value/json.h"

namespace race::edit {

/// JSON in which ' stands for ".
inline Value json(std::string text) {
  std::replace(text.begin(), text.end(), '\'', '"');
  return parse_json(text).value();
}

inline rcm::Document document_of(const Value& json) {
  rcm::Draft draft = rcm::read_draft(json);
  EXPECT_TRUE(draft.errors.empty()) << (draft.errors.empty() ? "" : to_string(draft.errors.front()));
  return draft.document;
}

/// A root with children A, B, C and a library with L; the id of each is its name in small letters.
inline rcm::Document small_document() {
  return document_of(json(R"({'rcm': 1, 'library': [
      {'state': 'L', 'ports': [{'name': 'done', 'when': 'True', 'meta': {'id': 'ldone'}}], 'meta': {'id': 'l'}}],
    'root': {'state': 'R', 'first': 'A',
      'parameters': [{'name': 'p', 'value': 1, 'meta': {'id': 'p'}}],
      'variables': [{'name': 'v', 'initial': 0, 'meta': {'id': 'v'}}],
      'actions': [{'when': 'True', 'do': 'var.v = par.p', 'meta': {'id': 'act'}}],
      'children': [
        {'state': 'A', 'ports': [{'name': 'done', 'when': 'True', 'to': 'B', 'meta': {'id': 'adone'}}],
         'meta': {'id': 'a', 'title': 'Start'}},
        {'state': 'B', 'children': [{'state': 'X', 'meta': {'id': 'x'}}, {'state': 'Y', 'meta': {'id': 'y'}}],
         'first': 'X', 'meta': {'id': 'b'}},
        {'barrier': 'C', 'to': ['A'], 'meta': {'id': 'c'}}],
      'meta': {'id': 'r'}},
    'layout': {'a': {'x': 1}}})"));
}

inline Edit edit_of(std::string operations) {
  auto edit = read_edit(Dict{{"operations", json(std::move(operations))}});
  EXPECT_TRUE(edit) << (edit ? "" : to_string(edit.error().front()));
  return edit ? *edit : Edit{};
}

/// The ids of the children of a state, with spaces between them.
inline std::string children_of(const Tree& tree, std::string_view parent) {
  std::string out;
  for (const std::string& id : tree.list(parent, ListName::children)) out += (out.empty() ? "" : " ") + id;
  return out;
}

inline std::string text_of(const Tree& tree) { return rcm::format_document(tree.document()); }

}  // namespace race::edit
