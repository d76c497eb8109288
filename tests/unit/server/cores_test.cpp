#include "server/execution/cores.h"

#include <gtest/gtest.h>

#include <future>

#include "core/rcm/document.h"
#include "tests/unit/server/bench.h"

namespace race::server {
namespace {

struct CoresTest : testing::Test, CoreWatcher {
  ~CoresTest() override {
    store.writer->close();
    pool.reset();
  }

  void core_changed(const std::string& id, Value) override { found.set_value(cores.find(id).has_value()); }
  void core_removed(const std::string& id) override { removed.push_back(id); }
  void state_snapshot(const std::string&, Value) override {}
  void state_changed(const std::string&, Value) override {}
  void derivation_snapshot(const std::string&, Value) override {}
  void derived(const std::string&, Value) override {}
  void printed(const std::string&, const std::string&) override {}

  std::promise<bool> found;
  std::vector<std::string> removed;
  services::WorldClock clock;
  NoObserver observer;
  services::Host host{clock, observer};
  std::unique_ptr<Pool> pool = std::make_unique<Pool>(1);
  TemporaryStore store;
  Cores cores{*pool, host, *this, *store.runs, *store.writer};
};

TEST_F(CoresTest, WhoHearsOfACoreCanFindIt) {
  const auto document = rcm::read_document_text(R"({"rcm": 1, "root": {"state": "R"}})").value();
  ASSERT_TRUE(cores.create({"r", 1, document}, {}));
  EXPECT_TRUE(found.get_future().get());
}

TEST_F(CoresTest, ARemovedCoreIsReportedAndCannotBeFound) {
  const auto document = rcm::read_document_text(R"({"rcm": 1, "root": {"state": "R"}})").value();
  const std::string id = cores.create({"r", 1, document}, {}).value()->id();
  EXPECT_TRUE(cores.remove(id));
  EXPECT_EQ(removed, std::vector{id});
  EXPECT_EQ(cores.find(id).error().code, ErrorCode::not_found);
  EXPECT_EQ(cores.remove(id).error().code, ErrorCode::not_found);
}

}  // namespace
}  // namespace race::server
