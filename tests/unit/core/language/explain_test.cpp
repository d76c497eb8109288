// Explanations: why a condition is not fulfilled, and which change fulfils it.
#include "core/language/evaluate/explain.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/core/language/environment.h"

namespace race::language::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Explanation of(Runner& r, std::string_view text) { return explain(r.code(text, CodeKind::condition), r.state); }

TEST(Explain, ShowsAtomsWithWhatTheyRead) {
  Runner r;
  r.state.set(State::res_x, Value(1));
  r.state.deliver(0, Value(Dict{{"x", Value(4)}}));
  const Explanation e = of(r, "res.x > 2 and (not svc.t.data.x < res.x or chi.C)");
  EXPECT_EQ(e.value, Truth::no);
  ASSERT_EQ(e.atoms.size(), 3U);
  EXPECT_EQ(e.atoms[0].text, "res.x > 2");
  EXPECT_EQ(e.atoms[1].text, "svc.t.data.x < res.x");
  EXPECT_EQ(e.atoms[1].value, Truth::no) << "also what evaluation passed over";
  ASSERT_EQ(e.atoms[1].reads.size(), 2U);
  EXPECT_EQ(e.atoms[1].reads[0].text, "svc.t.data.x");
  EXPECT_EQ(e.atoms[1].reads[0].value, Value(4));
  EXPECT_EQ(e.atoms[1].reads[1].text, "res.x");
  EXPECT_EQ(e.atoms[1].where, (SourceRange{1, 20, 1, 40}));
}

TEST(Explain, NamesTheAtomWhoseChangeFulfils) {
  Runner r;
  r.state.set(State::res_x, Value(1));
  const Explanation e = of(r, "res.x > 2 and not chi.C");
  EXPECT_THAT(e.decisive, ElementsAre(0U));
  EXPECT_TRUE(e.atoms[0].wanted);
  EXPECT_FALSE(e.together);
  r.state.set(State::res_x, Value(3));
  EXPECT_EQ(r.condition("res.x > 2 and not chi.C"), "True") << "the change was made";
  EXPECT_THAT(of(r, "res.x > 2 and not chi.C").decisive, IsEmpty());
}

TEST(Explain, NamesEveryAtomThatAloneSuffices) {
  Runner r;
  EXPECT_THAT(of(r, "chi.C or res.unset > 1").decisive, ElementsAre(0U, 1U));
  r.state.raise(State::child_active);
  const Explanation e = of(r, "not chi.C");
  EXPECT_THAT(e.decisive, ElementsAre(0U));
  EXPECT_FALSE(e.atoms[0].wanted);
}

TEST(Explain, NamesTheSmallestSetIfNoneSufficesAlone) {
  Runner r;
  const Explanation e = of(r, "(chi.C and port.p and chi.b) or (svc.t.data and res.unset)");
  EXPECT_TRUE(e.together);
  EXPECT_THAT(e.decisive, ElementsAre(3U, 4U));
}

TEST(Explain, TreatsAtomsOfOneTextAsOne) {
  Runner r;
  EXPECT_THAT(of(r, "chi.C and (port.p or chi.C)").decisive, ElementsAre(0U, 2U));
  EXPECT_THAT(of(r, "chi.C and not chi.C").decisive, IsEmpty()) << "nothing would do";
  EXPECT_THAT(of(r, "1 > 2").decisive, IsEmpty()) << "a constant cannot change";
  EXPECT_THAT(of(r, "1 > 2 or chi.C").decisive, ElementsAre(1U));
  EXPECT_THAT(of(r, "1 > 2 or chi.C and res.unset > 1").decisive, ElementsAre(1U, 2U));
  EXPECT_THAT(of(r, "False and chi.C").decisive, IsEmpty());
}

TEST(Explain, ShowsFaultsOfAtoms) {
  Runner r;
  const Explanation e = of(r, "chi.C or 1 // 0");
  EXPECT_EQ(e.value, Truth::fault);
  EXPECT_EQ(e.atoms[1].value, Truth::fault);
  EXPECT_THAT(e.decisive, ElementsAre(0U));
  EXPECT_THAT(of(r, "1 // int(chi.b) or chi.C").decisive, ElementsAre(0U)) << "a fault comes before what would decide";
  EXPECT_THAT(of(r, "1 // 0 or chi.C").decisive, IsEmpty()) << "and this one stays";
}

}  // namespace
}  // namespace race::language::test
