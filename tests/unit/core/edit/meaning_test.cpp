// Compound edits keep what a task does: with the same inputs, the document before and after makes the same calls.
#include <iostream>
#include <random>

#include "core/edit/compound.h"
#include "core/rcm/constraints.h"
#include "core/rcm/ids.h"
#include "core/rcm/translate.h"
#include "core/semantics/program.h"
#include "tests/unit/core/edit/documents.h"
#include "tests/unit/core/semantics/driven_run.h"
#include "tests/unit/core/semantics/random_models.h"
#include "tests/unit/setting.h"

namespace race::edit {
namespace {

using semantics::RandomModels;

/// The calls of a run with random inputs of this seed, a line each macro step, and how it ended.
std::string calls_of(const rcm::Document& document, std::uint64_t seed) {
  const auto native = rcm::translate(document);
  if (!native) return "no model: " + to_string(native.error().front());
  const auto program = semantics::Program::build(*native, RandomModels::services());
  if (!program) return "no program";
  semantics::DrivenRun run(*semantics::Run::create(*program, {}));
  RandomModels inputs(seed);
  std::uint64_t calls = 0;
  std::string out;
  for (int i = 0; i < 60 && run.status() == semantics::Status::running; ++i) {
    semantics::NoRecorder none;
    run.macro_step(none);
    for (const auto& call : run.take_calls()) {
      out += call.service + "." + call.name + to_json(Value(call.args)) + " ";
      calls = call.number;
    }
    out += "\n";
    inputs.post(std::vector<semantics::DrivenRun*>{&run}, calls);
  }
  return out + (run.fault() ? "fault" : run.outcome());
}

rcm::Document with_ids(rcm::State root) {
  rcm::Document out;
  out.root = std::move(root);
  rcm::give_ids(out);
  return out;
}

/// One state after the other, each of which calls with what it and those before it know.
class Sequences {
 public:
  explicit Sequences(std::uint64_t seed) : random_(seed) {}

  rcm::Document document() {
    const std::size_t count = 3 + pick(4);
    rcm::State root = named("Root");
    root.parameters.push_back(parameter("p", std::nullopt));
    root.parameters[0].value = Value(7);
    root.first = "S0";
    for (std::size_t i = 0; i < count; ++i) root.children.emplace_back(state(i, count));
    return with_ids(std::move(root));
  }

  std::size_t pick(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }

 private:
  static rcm::State named(std::string name) {
    rcm::State out;
    out.name = std::move(name);
    return out;
  }
  static rcm::Parameter parameter(std::string name, std::optional<std::string> from) {
    rcm::Parameter out;
    out.name = std::move(name);
    out.from = std::move(from);
    return out;
  }

  rcm::State state(std::size_t i, std::size_t count) {
    rcm::State out = named("S" + std::to_string(i));
    out.parameters.push_back(parameter("p", pick(2) == 0 ? "par.p" : "par.p + 1"));
    out.results.emplace_back().name = "r";
    out.results[0].initial = Value(static_cast<std::int64_t>(i));
    if (pick(2) == 0) out.parameters.push_back(parameter("q", "chi.S" + std::to_string(pick(count)) + ".res.r"));
    out.entry = out.parameters.size() > 1 ? "svc.t.o0(par.p, par.q)" : "svc.t.o1(par.p)";
    out.actions.push_back({"svc.t.s0.x > 1", "res.r = svc.t.s0.x\nsvc.t.o1(res.r)", {}});
    for (std::size_t k = 0; k < 2; ++k) {
      rcm::Port port;
      port.name = "p" + std::to_string(k);
      port.when = "svc.t.e" + std::to_string(pick(4)) + ".x < " + std::to_string(1 + pick(4));
      port.to = "S" + std::to_string(pick(count));
      out.ports.push_back(std::move(port));
    }
    return out;
  }

  std::mt19937_64 random_;
};

struct Setting {
  std::uint64_t seed = setting("RACE_SEED", 20261122);
  std::uint64_t models = setting("RACE_EDITED_MODELS", 12);
};

std::string edited_calls(const rcm::Document& document, const Edit& edit, std::uint64_t seed) {
  const auto applied = apply(document, edit);
  return applied ? calls_of(applied->document, seed) : to_string(applied.error());
}

/// For every third element of random models: the calls are the same after the edit that make(tree, id) gives, if any.
template <typename Make>
void expect_same_calls(Make make) {
  const Setting setting;
  std::size_t edits = 0;
  for (std::uint64_t seed = setting.seed; seed < setting.seed + setting.models; ++seed) {
    SCOPED_TRACE("RACE_SEED=" + std::to_string(seed));
    const rcm::Document document = with_ids(RandomModels(seed).model().root);
    const Tree tree = Tree::read(document).value();
    const Ids ids = tree.subtree(tree.root());
    const std::string calls = calls_of(document, seed);
    for (std::size_t i = seed % 3; i < ids.size(); i += 3) {
      const Expected<Edit> edit = make(tree, ids[i]);
      if (!edit) continue;
      ++edits;
      ASSERT_EQ(edited_calls(document, *edit, seed), calls) << name_of(tree.find(ids[i])->content);
    }
  }
  EXPECT_GT(edits, setting.models);
}

TEST(Meaning, OfARenamedElementIsTheSame) {
  expect_same_calls([](const Tree& tree, const std::string& id) -> Expected<Edit> {
    const Element& element = *tree.find(id);
    if (element.parent == tree.root() && element.list == ListName::ports)
      return unexpected(ErrorCode::not_accepted, "the outcome of the run is the name of a port of the root");
    return rename(tree, id, "Renamed");
  });
}

TEST(Meaning, OfAStateThatGoesToTheLibraryIsTheSame) {
  expect_same_calls([](const Tree& tree, const std::string& id) { return extract(tree, id, "Extracted", "seed"); });
}

TEST(Meaning, OfASequenceIsTheSameInAGroup) {
  const Setting setting;
  std::size_t grouped = 0;
  for (std::uint64_t seed = setting.seed; seed < setting.seed + 5 * setting.models; ++seed) {
    SCOPED_TRACE("RACE_SEED=" + std::to_string(seed));
    const rcm::Document document = Sequences(seed).document();
    ASSERT_TRUE(rcm::violations(document).empty()) << to_string(rcm::violations(document).front());
    const Tree tree = Tree::read(document).value();
    const Ids& children = tree.list(tree.root(), ListName::children);
    for (std::size_t i = 0; i < children.size(); ++i) {
      for (std::size_t k = i; k < children.size(); ++k) {
        const auto edit = group(tree, {children[i], children[k]}, "Grouped", "seed");
        if (!edit) continue;
        ++grouped;
        ASSERT_EQ(edited_calls(document, *edit, seed), calls_of(document, seed))
            << rcm::format_document(document) << rcm::format_document(apply(document, *edit)->document);
      }
    }
  }
  std::cout << grouped << " groups\n";
  EXPECT_GT(grouped, setting.models);
}

}  // namespace
}  // namespace race::edit
