// The store of documents on a disk that loses power, is full or fails, at each operation of a scenario: what was
// acknowledged is there, and what was refused has changed nothing.
#include "tests/unit/server/document_scenario.h"
#include "tests/unit/services/sqlite/faulty_vfs.h"
#include "tests/unit/setting.h"

namespace race::server {
namespace {

namespace fs = std::filesystem;
using sqlite::FaultyVfs;

class DocumentFaults : public DocumentStore {
 protected:
  DocumentFaults() {
    fs::create_directories(disk());
    fs::create_directories(after());
    EXPECT_TRUE(sqlite::migrate(*sqlite::open(empty()), store_migrations()));
    reset();
    const auto documents = Documents::open(file()).value();
    contents_.push_back(content_of(*documents).value());
    for (const Step& step : steps_) {
      step(*documents).value();
      contents_.push_back(content_of(*documents).value());
    }
  }

  fs::path disk() const { return folder_ / "disk"; }
  fs::path after() const { return folder_ / "after"; }
  std::string file() const { return disk() / "race.sqlite"; }
  std::string empty() const { return folder_ / "empty.sqlite"; }
  void reset() const {
    for (const char* suffix : {"", "-wal", "-shm"}) fs::remove(file() + suffix);
    fs::copy_file(empty(), file());
  }

  const std::vector<Step> steps_ = scenario();
  std::vector<Content> contents_;  // before the first step and after each
};

TEST_F(DocumentFaults, LoseNothingAcknowledgedWithThePower) {
  reset();
  FaultyVfs vfs;
  auto documents = Documents::open(file()).value();
  std::size_t done = 0;
  vfs.before_each([&](std::uint64_t operation) {
    for (const double kept : {0.0, 0.5, 1.0}) {
      vfs.lose_power(disk(), after(), kept, operation);
      const auto content = read_store(after() / "race.sqlite");
      ASSERT_TRUE(content) << content.error().front().message;
      EXPECT_TRUE(*content == contents_[done] || (done < steps_.size() && *content == contents_[done + 1]))
          << "before operation " << operation << " of step " << done << ", kept " << kept;
    }
  });
  for (const Step& step : steps_) {
    step(*documents).value();
    ++done;
  }
  documents.reset();  // closes the file, which takes over its log
  EXPECT_GT(vfs.operations(), 60U);
}

TEST_F(DocumentFaults, ChangeNothingAndAreOverWhenTheDiskWorks) {
  const std::uint64_t stride = setting("RACE_FAULT_STRIDE", 1);  // every so many operations
  for (const auto fault : {FaultyVfs::Fault::full, FaultyVfs::Fault::io})
    for (const bool for_ever : {false, true}) {
      bool failed = true;
      for (std::uint64_t nth = 1; failed; nth += stride) {
        SCOPED_TRACE("operation " + std::to_string(nth) + (for_ever ? " and all after" : ""));
        reset();
        FaultyVfs vfs;
        vfs.fail_at(nth, fault, for_ever);
        auto documents = Documents::open(file());
        if (!documents) {
          EXPECT_EQ(documents.error().code, ErrorCode::storage) << documents.error().message;
          vfs.repair();
          documents = Documents::open(file());
        }
        std::size_t refused = 0;
        for (std::size_t i = 0; i < steps_.size(); ++i) {
          const auto put = steps_[i](**documents);
          if (put) continue;
          ++refused;
          EXPECT_EQ(error_of(put).code, ErrorCode::storage) << put.error().front().message;
          if (for_ever) {
            EXPECT_EQ(error_of(steps_[i](**documents)).code, ErrorCode::storage);
          }
          vfs.repair();
          EXPECT_EQ(content_of(**documents).value(), contents_[i]);
          EXPECT_TRUE(steps_[i](**documents));
        }
        failed = vfs.has_failed();
        vfs.repair();
        EXPECT_LE(refused, 1U);
        EXPECT_EQ(content_of(**documents).value(), contents_.back());
        EXPECT_TRUE(sqlite::check(*sqlite::open(file())));
        if (HasFailure()) return;
      }
    }
}

}  // namespace
}  // namespace race::server
