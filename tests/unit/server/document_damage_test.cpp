// A damaged store of documents: what is read is what was stored, or an error that says so. RACE_SEED and RACE_FLIPS
// choose the bits.
#include <SQLiteCpp/Database.h>

#include <fstream>
#include <iostream>
#include <random>

#include "tests/unit/server/document_scenario.h"
#include "tests/unit/setting.h"

namespace race::server {
namespace {

class DocumentDamage : public DocumentStore {
 protected:
  DocumentDamage() {
    const auto documents = open();
    for (const Step& step : scenario()) step(*documents).value();
    content_ = content_of(*documents).value();
  }
  void execute(const std::string& sql) const { SQLite::Database(path(), SQLite::OPEN_READWRITE).exec(sql); }

  Content content_;
};

template <typename T>
void expect_corrupt(const Checked<T>& result, const std::string& path) {
  const Error error = error_of(result);
  EXPECT_EQ(error.code, ErrorCode::corrupt);
  EXPECT_EQ(error.path, path);
}

TEST_F(DocumentDamage, OfAnyFieldOfARevisionIsNamed) {
  for (const char* change : {"author = 'Eve'", "time = time + 1", "message = 'x'", "origin = 'put'", "origin = 'x'",
                             "from_document = 'x'", "from_revision = 7", "errors = errors + 1", "doc = 'x'",
                             "text_digest = zeroblob(32)", "digest = zeroblob(32)"}) {
    SCOPED_TRACE(change);
    const auto before = std::filesystem::path(path() + ".before");
    std::filesystem::copy_file(path(), before, std::filesystem::copy_options::overwrite_existing);
    execute("UPDATE revision SET " + std::string(change) + " WHERE document = 'task' AND number = 4");
    const auto documents = Documents::open(path()).value();
    expect_corrupt(documents->entry("task"), "task/revisions/4");
    expect_corrupt(documents->get("task"), "task/revisions/4");
    expect_corrupt(documents->revisions("task", {}, 100), "task/revisions/4");
    expect_corrupt(documents->list(), "task/revisions/4");
    expect_corrupt(documents->put("task", kTask), "task/revisions/4");
    EXPECT_TRUE(documents->entry("task", 3)) << "the others can be read";
    EXPECT_TRUE(documents->revisions("task", 4, 100));
    EXPECT_TRUE(documents->entry("mine"));
    std::filesystem::copy_file(before, path(), std::filesystem::copy_options::overwrite_existing);
  }
}

TEST_F(DocumentDamage, OfOneDocumentLeavesTheOthersListed) {
  execute("UPDATE revision SET author = 'Eve' WHERE document = 'task'; DELETE FROM document WHERE name = 'mine'");
  const auto documents = Documents::open(path()).value();
  const DocumentHeads heads = documents->heads().value();
  ASSERT_EQ(heads.revisions.size(), 1U);
  EXPECT_EQ(heads.revisions[0].document, "large");
  ASSERT_EQ(heads.damaged.size(), 2U);
  EXPECT_EQ(heads.damaged[0].path, "mine");
  EXPECT_EQ(heads.damaged[1].path, "task/revisions/4");
}

TEST_F(DocumentDamage, OfTheDemoLeavesItAndTheOthersArePut) {
  const auto demo = folder_ / "demo";
  std::filesystem::create_directory(demo);
  for (const char* name : {"task.rcm.json", "another.rcm.json"}) std::ofstream(demo / name) << kTask;
  execute("UPDATE revision SET author = 'Eve' WHERE document = 'task'");
  const auto documents = Documents::open(path()).value();
  ASSERT_TRUE(documents->put_demo(demo, 1));
  EXPECT_TRUE(documents->get("another"));
  expect_corrupt(documents->entry("task"), "task/revisions/4");
}

TEST_F(DocumentDamage, OfATextIsNamedWhenItIsRead) {
  execute("UPDATE revision SET text = text || ' ' WHERE document = 'task' AND number = 4");
  const auto documents = Documents::open(path()).value();
  expect_corrupt(documents->entry("task"), "task/revisions/4");
  expect_corrupt(documents->branch("task", {"new", 4}, {}), "task/revisions/4");
  expect_corrupt(documents->restore("task", 4, {}), "task/revisions/4");
  EXPECT_TRUE(documents->list());
}

TEST_F(DocumentDamage, LostRevisionsAreNamed) {
  execute("DELETE FROM revision WHERE (document = 'task' AND number IN (2, 4)) OR document = 'mine'");
  const auto documents = Documents::open(path()).value();
  expect_corrupt(documents->entry("task"), "task/revisions/4");
  expect_corrupt(documents->entry("task", 2), "task/revisions/2");
  expect_corrupt(documents->revisions("task", {}, 100), "task/revisions/4");
  expect_corrupt(documents->revisions("task", 4, 100), "task/revisions/2");
  expect_corrupt(documents->revisions("task", 3, 100), "task/revisions/2");
  EXPECT_EQ(documents->revisions("task", 2, 100)->size(), 1U);
  expect_corrupt(documents->entry("mine"), "mine/revisions/5");
  expect_corrupt(documents->list(), "mine/revisions/5");
}

TEST_F(DocumentDamage, OfTheEntryOfADocumentIsNamed) {
  for (const char* sql :
       {"DELETE FROM document WHERE name = 'task'", "UPDATE document SET last = 3 WHERE name = 'task'",
        "UPDATE document SET first = 2 WHERE name = 'task'"}) {
    SCOPED_TRACE(sql);
    const auto before = std::filesystem::path(path() + ".before");
    std::filesystem::copy_file(path(), before, std::filesystem::copy_options::overwrite_existing);
    execute(sql);
    const auto documents = Documents::open(path()).value();
    expect_corrupt(documents->entry("task"), "task");
    expect_corrupt(documents->revisions("task", {}, 100), "task");
    expect_corrupt(documents->put("task", kTask), "task");
    expect_corrupt(documents->list(), "task");
    EXPECT_TRUE(documents->entry("mine"));
    std::filesystem::copy_file(before, path(), std::filesystem::copy_options::overwrite_existing);
  }
}

TEST_F(DocumentDamage, OfOneBitIsNamedOrHarmless) {
  const std::uint64_t seed = setting("RACE_SEED", 10), flips = setting("RACE_FLIPS", 400);
  std::cout << "RACE_SEED=" << seed << " RACE_FLIPS=" << flips << std::endl;
  std::ifstream stream(path(), std::ios::binary);
  const std::string sound{std::istreambuf_iterator<char>(stream), {}};
  std::mt19937_64 random(seed);
  const std::string path = folder_ / "damaged.sqlite";
  std::size_t named = 0;
  for (std::uint64_t i = 0; i < flips; ++i) {
    // Every fourth one in the first page, which says what is where.
    const std::size_t byte = random() % (i % 4 == 0 ? 4096 : sound.size()), bit = random() % 8;
    SCOPED_TRACE("byte " + std::to_string(byte) + ", bit " + std::to_string(bit));
    std::string damaged = sound;
    damaged[byte] = static_cast<char>(static_cast<unsigned char>(damaged[byte]) ^ (1U << bit));
    for (const char* suffix : {"-wal", "-shm"}) std::filesystem::remove(path + suffix);
    std::ofstream(path, std::ios::binary) << damaged;
    const auto content = read_store(path);
    if (content)
      EXPECT_EQ(*content, content_);
    else
      ++named;
  }
  EXPECT_GT(named, flips / 5) << "hardly anything was damaged";
}

}  // namespace
}  // namespace race::server
