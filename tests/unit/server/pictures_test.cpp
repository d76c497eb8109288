// What cameras saw: kept in order, never more than their bound, and gone with the run.
#include "server/store/pictures.h"

#include <SQLiteCpp/Database.h>

#include "tests/unit/server/run_store.h"

namespace race::server {
namespace {

Picture picture(int number) { return {"camera", static_cast<std::uint64_t>(number), 0.5 * number, "AAAA"}; }

class StoredPictures : public StoredRuns {
 protected:
  StoredPictures() { runs_->create(run_of(counting({})), 1).value(); }
  void append(int from, int to, RunId run = 1) {
    std::vector<Picture> pictures;
    for (int i = from; i < to; ++i) pictures.push_back(picture(i));
    ASSERT_TRUE(pictures_->append(run, pictures));
  }
  std::vector<std::int64_t> numbers() {
    std::vector<std::int64_t> found;
    const auto list = pictures_->list(1).value();
    for (const NumberedPicture& each : list) found.push_back(each.number);
    return found;
  }

  const std::unique_ptr<Runs> runs_ = open();
  const std::unique_ptr<Pictures> pictures_ = Pictures::open(path()).value();
};

TEST_F(StoredPictures, AreKeptInOrderOverRestarts) {
  append(0, 2);
  append(2, 3);
  const auto again = Pictures::open(path()).value();
  const auto list = again->list(1).value();
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[2].number, 2);
  EXPECT_EQ(list[2].picture.service, "camera");
  EXPECT_EQ(list[2].picture.step, 2u);
  EXPECT_EQ(list[2].picture.time, 1.0);
  EXPECT_EQ(list[2].picture.jpeg, "");
  EXPECT_EQ(again->read(1, 2)->jpeg, "AAAA");
  EXPECT_EQ(again->read_all(1)->at(1).time, 0.5);
}

TEST_F(StoredPictures, AreThinnedOutAtTheirBound) {
  append(0, 400);
  EXPECT_EQ(numbers().size(), Pictures::kMost);
  append(400, 401);
  const auto thinned = numbers();
  ASSERT_EQ(thinned.size(), 201u);
  for (std::size_t i = 0; i < thinned.size(); ++i) ASSERT_EQ(thinned[i], static_cast<std::int64_t>(2 * i));
  append(401, 5000);
  EXPECT_LE(numbers().size(), Pictures::kMost);
  EXPECT_GE(numbers().size(), Pictures::kMost / 2);
}

TEST_F(StoredPictures, ThatAreNotThereAreNamed) {
  append(0, 1);
  EXPECT_EQ(pictures_->read(1, 1).error().code, ErrorCode::not_found);
  EXPECT_EQ(pictures_->read(2, 0).error().code, ErrorCode::not_found);
}

TEST_F(StoredPictures, CountInTheSizeOfARunAndGoWithIt) {
  ASSERT_TRUE(runs_->set_status(1, "aborted"));
  const std::uint64_t before = runs_->sizes()->at(0).second;
  append(0, 100);
  EXPECT_EQ(runs_->sizes()->at(0).second, before + 100 * 4);
  ASSERT_TRUE(runs_->remove(1));
  EXPECT_TRUE(numbers().empty());
  EXPECT_EQ(SQLite::Database(path()).execAndGet("SELECT count(*) FROM picturing").getInt(), 0);
}

TEST_F(StoredPictures, OfARunThatIsGoneAreNotKept) {
  append(0, 3, 7);
  EXPECT_TRUE(pictures_->list(7)->empty());
}

TEST_F(StoredPictures, AreNoneOfRunsThatAnOlderVersionStored) {
  SQLite::Database(path(), SQLite::OPEN_READWRITE)
      .exec("DROP TABLE picture; DROP TABLE picturing; DROP TABLE proposal; PRAGMA user_version = 9");
  const auto upgraded = Pictures::open(path()).value();
  EXPECT_TRUE(upgraded->list(1)->empty());
  ASSERT_TRUE(upgraded->append(1, {picture(0)}));
  EXPECT_EQ(upgraded->list(1)->size(), 1u);
}

TEST_F(StoredPictures, AreNamedIfTheyAreDamaged) {
  append(0, 3);
  SQLite::Database(path(), SQLite::OPEN_READWRITE).exec("UPDATE picture SET step = 9 WHERE number = 1");
  const auto read = pictures_->read(1, 1);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::corrupt);
  EXPECT_EQ(read.error().path, "runs/1/pictures/1");
  EXPECT_EQ(pictures_->read_all(1).error().code, ErrorCode::corrupt);
  EXPECT_TRUE(pictures_->read(1, 2));
}

}  // namespace
}  // namespace race::server
