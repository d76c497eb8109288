// What a macro step prints and calls leaves its core in pieces: all of it, in order.
#include <gmock/gmock.h>

#include "core/rcm/document.h"
#include "core/rcm/native.h"
#include "core/rcm/translate.h"
#include "core/rsm/document.h"
#include "tests/unit/server/hosted_cores.h"

namespace race::server {
namespace {

struct Amount {
  int prints, calls;
};
std::ostream& operator<<(std::ostream& out, Amount amount) {
  return out << amount.prints << " prints, " << amount.calls << " calls";
}

struct PiecesTest : HostedCores, testing::WithParamInterface<Amount> {
  // A core that prints and calls so much when it starts.
  std::shared_ptr<Core> core_of(Amount amount) {
    const std::string entry = "for i in range(" + std::to_string(amount.prints) +
                              "):\\n    print(i)\\nfor i in range(" + std::to_string(amount.calls) +
                              "):\\n    svc.many.op()";
    const std::string text = R"json({"rcm": 1, "root": {"state": "R", "entry": ")json" + entry + "\"}}";
    const auto document = rcm::read_document_text(text).value();
    const auto native = rcm::translate(document).value();
    const auto many =
        rsm::read_service_text(R"({"rsm": 1, "name": "many", "operations": [{"name": "op"}]})", "many").value();
    execution::JournalHeader header{
        rcm::write_native(document, native), semantics::Program::build(native, {{"many", many}}).value(), {}, {}};
    header.native.freeze();
    RunRecord run = runs->create({"many", 1, header, {}}, 0).value();
    return Core::create(std::move(run), header, {*pool, host, *this, *runs, *writer, replays, deadlines, watchdog})
        .value();
  }
};

TEST_P(PiecesTest, HoldAllInOrder) {
  begin_server();
  const auto core = core_of(GetParam());
  ASSERT_TRUE(core->start());
  ASSERT_TRUE(core->state()) << "answered after all that was said before";
  std::vector<std::string> printed = all_told(), expected;
  std::erase_if(printed, [](const std::string& each) { return each.find_first_not_of("0123456789") != each.npos; });
  for (int i = 0; i < GetParam().prints; ++i) expected.push_back(std::to_string(i));
  EXPECT_EQ(printed, expected);
  EXPECT_EQ(observer.calls().size(), static_cast<std::size_t>(GetParam().calls));
}

INSTANTIATE_TEST_SUITE_P(Amounts, PiecesTest,
                         testing::Values(Amount{0, 0}, Amount{32, 32}, Amount{33, 0}, Amount{0, 33}, Amount{5, 33},
                                         Amount{32, 33}, Amount{33, 33}, Amount{100, 100}, Amount{900, 4000}));

}  // namespace
}  // namespace race::server
