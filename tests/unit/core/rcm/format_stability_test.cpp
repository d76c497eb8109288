// race fmt is stable: an edit of one element changes that element's lines alone. Of every document of the tests, the
// demo and the examples, each element is edited in several ways; the lines of the others must stay as they are.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/rcm/document.h"
#include "core/rcm/ids.h"
#include "tests/unit/core/rcm/cases.h"
#include "tests/unit/setting.h"

namespace race::rcm {
namespace {

using Ids = std::set<std::string>;

struct Line {
  std::string text;   // without the comma at its end
  std::string owner;  // id of the innermost element that it belongs to; empty: the document
};

std::string trimmed(const std::string& line) { return line.substr(std::min(line.find_first_not_of(' '), line.size())); }

/// The id that a line states, if it is one of `ids`.
std::string id_in(const std::string& line, const Ids& ids) {
  const auto at = line.find("\"id\": \"");
  if (at == std::string::npos) return "";
  const auto start = at + 7;
  const std::string id = line.substr(start, line.find('"', start) - start);
  return ids.contains(id) ? id : "";
}

/// The lines of a formatted document with their owners.
std::vector<Line> lines_of(const std::string& text, const Ids& ids) {
  std::vector<Line> out;
  std::vector<std::vector<std::size_t>> open(1);  // lines of the objects that are open, innermost last
  std::vector<std::size_t> indents;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (line.ends_with(',')) line.pop_back();
    const std::string inner = trimmed(line);
    const std::size_t indent = line.size() - inner.size();
    out.push_back({line, ""});
    if (indent > 0 && (inner == "{" || inner == "\"root\": {")) {
      open.emplace_back();
      indents.push_back(indent);
    }
    const std::string id = id_in(line, ids);
    if (inner.starts_with("{\"")) {
      out.back().owner = id;  // an element on one line
    } else {
      open.back().push_back(out.size() - 1);
      if (!id.empty()) out[open.back().front()].owner = id;
    }
    if (!indents.empty() && inner == "}" && indent == indents.back()) {
      for (const std::size_t number : open.back()) out[number].owner = out[open.back().front()].owner;
      open.pop_back();
      indents.pop_back();
    }
  }
  return out;
}

/// The text without the lines that belong to `removed`, and without fields that become empty by that.
std::string without(const std::string& text, const Ids& ids, const Ids& removed) {
  std::vector<std::string> out;
  for (const Line& line : lines_of(text, ids)) {
    if (removed.contains(line.owner)) continue;
    const bool closes = trimmed(line.text) == "]" || trimmed(line.text) == "}";
    if (closes && !out.empty() && (out.back().ends_with(": [") || out.back().ends_with(": {"))) {
      out.pop_back();
    } else {
      out.push_back(line.text);
    }
  }
  std::string joined;
  for (const std::string& line : out) joined += line + "\n";
  return joined;
}

/// Calls visit(list) for every list of elements.
template <typename Visit>
void visit_lists(State& state, Visit visit) {
  visit(state.parameters);
  visit(state.results);
  visit(state.variables);
  visit(state.actions);
  visit(state.children);
  visit(state.ports);
  for (Node& node : state.children) {
    if (auto* inner = std::get_if<State>(&node)) visit_lists(*inner, visit);
  }
}

template <typename Visit>
void visit_lists(Document& document, Visit visit) {
  visit(document.library);
  for (State& state : document.library) visit_lists(state, visit);
  visit_lists(document.root, visit);
}

template <typename Element>
Meta& meta_of(Element& element) {
  return element.meta;
}
Meta& meta_of(Node& node) {
  return std::visit([](auto& n) -> Meta& { return n.meta; }, node);
}

/// The ids of the elements of these lists and below.
template <typename Element>
void collect(std::vector<Element>& list, Ids& out) {
  for (Element& element : list) out.insert(meta_of(element).id);
}

Ids ids_of(Document document) {
  Ids out{document.root.meta.id};
  visit_lists(document, [&](auto& list) { collect(list, out); });
  return out;
}

Ids ids_of(State& state) {
  Ids out{state.meta.id};
  visit_lists(state, [&](auto& list) { collect(list, out); });
  return out;
}

template <typename Element>
Ids ids_of(Element& element) {
  return {element.meta.id};
}
Ids ids_of(Node& node) {
  return std::visit([](auto& n) { return ids_of(n); }, node);
}

// A change of what an element says.
void change_text(State& state, const std::string& text) { state.doc = text; }
void change_text(Barrier& barrier, const std::string& text) { barrier.to.push_back(text); }
void change_text(Parameter& parameter, const std::string& text) { parameter.from = text; }
void change_text(Datum& datum, const std::string& text) { datum.unit = text; }
void change_text(Action& action, const std::string& text) { action.when = text; }
void change_text(Port& port, const std::string& text) { port.when = text; }
void change_text(Node& node, const std::string& text) {
  std::visit([&](auto& n) { change_text(n, text); }, node);
}

template <typename Element>
void rename(Element& element) {
  element.name += "_renamed";
}
void rename(Action& action) { action.code += "\nvar.x = 1"; }
void rename(Node& node) {
  std::visit([](auto& n) { rename(n); }, node);
}

class Stability {
 public:
  explicit Stability(Document document) : document_(std::move(document)), before_(format_document(document_)) {
    ids_ = ids_of(document_);
  }

  /// Edits every `step`-th element.
  void check(std::size_t step) {
    std::size_t lists = 0, elements = 0;
    visit_lists(document_, [&](auto& list) {
      for (std::size_t i = 0; i < list.size(); ++i)
        if (elements++ % step == 0) check_element(lists, i);
      ++lists;
    });
  }

 private:
  /// Makes an edit of a copy: edit(copy, list `number` of it).
  template <typename Edit>
  Document edited(std::size_t number, Edit edit) const {
    Document copy = document_;
    std::size_t at = 0;
    bool done = false;
    visit_lists(copy, [&](auto& list) {
      if (at++ == number && !done) {
        edit(list);
        done = true;
      }
    });
    return copy;
  }

  void check_element(std::size_t number, std::size_t i) {
    const auto in_place = [&](std::string_view what, auto edit) {
      std::string id;
      const Document after = edited(number, [&](auto& list) {
        id = meta_of(list[i]).id;
        edit(list[i]);
      });
      expect_equal_but(what, after, {id});
    };
    in_place("changed text", [](auto& element) { change_text(element, "short"); });
    in_place("long text", [](auto& element) { change_text(element, std::string(150, 'x')); });
    in_place("renamed", [](auto& element) { rename(element); });
    in_place("meta", [](auto& element) { meta_of(element).rest = Dict{{"min", List{List{List{1}}}}}; });
    check_lists(number, i);
    check_entries(number, i);
  }

  void check_lists(std::size_t number, std::size_t i) {
    Ids ids;
    const auto offset = static_cast<std::ptrdiff_t>(i);
    const Document removed = edited(number, [&](auto& list) {
      ids = ids_of(list[i]);
      list.erase(list.begin() + offset);
    });
    expect_equal_but("removed", removed, ids);
    const Document moved =
        edited(number, [&](auto& list) { std::rotate(list.begin(), list.begin() + offset, list.end()); });
    expect_equal_but("moved to the front", moved, moved == document_ ? Ids{} : front_ids(number, i));
    Document added = edited(number, [&](auto& list) { list.insert(list.begin() + offset, list[i]); });
    give_ids(added, &document_);
    Ids made;
    std::ranges::set_difference(ids_of(added), ids_, std::inserter(made, made.end()));
    expect_equal_but("copied", added, made);
  }

  /// A rotation moves the elements before `i` behind the others.
  Ids front_ids(std::size_t number, std::size_t i) const {
    Ids out;
    edited(number, [&](auto& list) {
      for (std::size_t k = 0; k < i; ++k) out.merge(ids_of(list[k]));
    });
    return out;
  }

  void check_entries(std::size_t number, std::size_t i) {
    std::string id;
    edited(number, [&](auto& list) { id = meta_of(list[i]).id; });
    Document placed = document_, noted = document_;
    if (placed.layout.is_null()) placed.layout = Dict{};
    placed.layout.mutable_dict().set(id, Dict{{"x", 1}});
    if (!noted.meta.is_dict()) noted.meta = Dict{};
    const Value* notes = noted.meta.find("notes");
    Dict entries = notes ? notes->as_dict() : Dict{};
    entries.set(id, "a note");
    noted.meta.mutable_dict().set("notes", std::move(entries));
    EXPECT_EQ(without_entry(format_document(placed), id), without_entry(before_, id)) << "layout of " << id;
    EXPECT_EQ(without_entry(format_document(noted), id), without_entry(before_, id)) << "note on " << id;
  }

  /// Without the lines of `layout` and `notes` for `id`, and without what is empty then.
  std::string without_entry(const std::string& text, const std::string& id) const {
    std::string kept;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
      if (!trimmed(line).starts_with('"' + id + "\": ")) kept += line + "\n";
    }
    for (std::string last; last != kept;) {
      last = kept;
      kept = without(last, ids_, {"none"});
    }
    return kept;
  }

  void expect_equal_but(std::string_view what, const Document& after, const Ids& changed) {
    const std::string text = format_document(after);
    EXPECT_EQ(without(text, ids_of(after), changed), without(before_, ids_, changed))
        << what << ": " << testing::PrintToString(changed);
  }

  Document document_;
  std::string before_;
  Ids ids_;
};

struct File {
  std::filesystem::path path;
  Document document;
};

std::vector<File> documents() {
  std::vector<std::filesystem::path> paths;
  for (const auto& folder : cases(false)) paths.push_back(folder / "model.json");
  for (const char* folder : {"/deploy/demo", "/api/examples"}) {
    for (const auto& entry : std::filesystem::directory_iterator(RACE_SOURCE_DIR + std::string(folder))) {
      const std::string name = entry.path().filename();
      if (name.ends_with(".rcm.json") || name.starts_with("document.")) paths.push_back(entry.path());
    }
  }
  std::vector<File> out;
  for (const auto& path : paths) {
    out.push_back({path, read_document_text(read_text(path)).value()});
    give_ids(out.back().document);
  }
  return out;
}

TEST(FormatDocument, ChangesTheLinesOfTheEditedElementAlone) {
  for (const File& file : documents()) {
    SCOPED_TRACE(file.path);
    const std::size_t elements = ids_of(file.document).size();
    Stability(file.document).check(elements / sample(20) + 1);
    if (testing::Test::HasFailure()) break;
  }
}

TEST(FormatDocument, ReadsBackAsTheSameDocumentAndText) {
  ASSERT_GE(documents().size(), 60U);
  for (const File& file : documents()) {
    const std::string text = format_document(file.document);
    Document document = read_document_text(text).value();
    EXPECT_EQ(document, file.document) << file.path;
    give_ids(document);
    EXPECT_EQ(format_document(document), text) << file.path;
  }
}

}  // namespace
}  // namespace race::rcm
