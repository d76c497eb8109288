// The elements of a program by id, and the ids of its elements.
#include <gtest/gtest.h>

#include "core/rcm/document.h"
#include "core/rcm/ids.h"
#include "core/rcm/translate.h"
#include "core/semantics/program.h"

namespace race::semantics {
namespace {

std::shared_ptr<const Program> program_of(std::string_view document, bool give_ids = false) {
  rcm::Document read = rcm::read_document_text(document).value();
  if (give_ids) rcm::give_ids(read);
  return Program::build(rcm::translate(read).value(), {}).value();
}

constexpr const char* kDocument = R"json({"rcm": 1,
  "library": [{"state": "L", "meta": {"id": "l"}, "ports": [{"name": "q", "when": "True", "meta": {"id": "lq"}}]}],
  "root": {"state": "R", "meta": {"id": "r"}, "parameters": [{"name": "a", "value": 1, "meta": {"id": "pa"}}],
    "results": [{"name": "b"}, {"name": "c", "meta": {"id": "rc"}}], "variables": [{"name": "d", "meta": {"id": "vd"}}],
    "actions": [{"when": "True", "do": "pass"}, {"when": "False", "do": "var.e = 1", "meta": {"id": "x"}}],
    "children": [{"barrier": "s", "to": ["A"], "meta": {"id": "s"}}, {"state": "A", "link": "L", "meta": {"id": "a"}},
                 {"state": "B", "link": "L", "meta": {"id": "b"}}]}})json";

TEST(ProgramIds, FindElementsOfEachKind) {
  const auto program = program_of(kDocument);
  EXPECT_EQ(program->state_with_id("r"), Program::root);
  EXPECT_EQ((*program)[program->state_with_id("b").value()].path, "R/B");
  EXPECT_EQ(program->barriers[program->ids.barriers.find("s").value()].path, "R/s");
  EXPECT_EQ(program->address(program->port_with_id(rcm::derived_id("b", "lq")).value()), "R/B.q");
  EXPECT_EQ(program->ids.actions.find("x"), 1U);
  const StateInfo& root = (*program)[Program::root];
  EXPECT_EQ(program->ids.values.find("pa"), root.first_parameter);
  EXPECT_EQ(program->ids.values.find("rc"), root.first_result + 1);
  EXPECT_EQ(program->ids.values.find("vd"), root.first_variable);
}

TEST(ProgramIds, FindNothingThatHasNoneOrIsOfAnotherKind) {
  const auto program = program_of(kDocument);
  EXPECT_EQ(program->state_with_id(""), std::nullopt);
  EXPECT_EQ(program->ids.values.find(""), std::nullopt);
  EXPECT_EQ(program->state_with_id("l"), std::nullopt) << "a library state is none of the native model";
  EXPECT_EQ(program->state_with_id("s"), std::nullopt);
  EXPECT_EQ(program->ids.actions[0], "");
}

TEST(ProgramIds, OfARepeatedIdFindTheFirst) {
  const auto program = program_of(R"({"rcm": 1, "root": {"state": "R", "children": [
      {"state": "A", "meta": {"id": "x"}}, {"state": "B", "meta": {"id": "x"}}]}})");
  EXPECT_EQ((*program)[program->state_with_id("x").value()].path, "R/A");
}

TEST(ProgramIds, LeadBackToEveryElement) {
  const auto program = program_of(kDocument, true);
  for (std::uint32_t s = 0; s < program->states.size(); ++s)
    EXPECT_EQ(program->state_with_id(program->id(StateId{s})), StateId{s});
  for (std::uint32_t b = 0; b < program->barriers.size(); ++b)
    EXPECT_EQ(program->ids.barriers.find(program->id(BarrierId{b})), b);
  for (std::uint32_t p = 0; p < program->ports.size(); ++p)
    EXPECT_EQ(program->port_with_id(program->id(PortId{p})), PortId{p});
  for (ActionId a = 0; a < program->actions.size(); ++a)
    EXPECT_EQ(program->ids.actions.find(program->ids.actions[a]), a);
  std::size_t declared = 0;
  for (ValueIndex v = 0; v < program->initial.size(); ++v) {
    if (program->ids.values[v].empty()) continue;  // a variable that is used undeclared is no element
    EXPECT_EQ(program->ids.values.find(program->ids.values[v]), v);
    ++declared;
  }
  EXPECT_EQ(declared, 4U);
  EXPECT_EQ(program->initial.size(), 5U);
}

}  // namespace
}  // namespace race::semantics
