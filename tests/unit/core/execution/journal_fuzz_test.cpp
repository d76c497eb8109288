// Random mutations of journals: reading never crashes; what is read is written as it stood there.
#include <gtest/gtest.h>

#include <array>
#include <iostream>

#include "tests/unit/core/execution/journals.h"
#include "tests/unit/core/execution/mutator.h"
#include "tests/unit/setting.h"

namespace race::execution {
namespace {

constexpr std::array<const char*, 14> kJournalWords = {"t",     "e0",     "o0",   "start", "abort", "event", "response",
                                                       "error", "result", "data", "link",  "1",     "x y",   ""};

class JournalMutator : private Mutator {
 public:
  explicit JournalMutator(std::uint64_t seed) : Mutator(seed, kJournalWords) {}

  Value journal(const std::vector<Value>& journals) {
    Value out = journals[below(journals.size())];
    if (below(4) == 0) {  // in what entries carry, where most changes are harmless
      replace_data(out);
    } else {
      for (std::size_t i = 1 + below(2); i > 0; --i) mutate(out);
    }
    return out;
  }

 private:
  // The data of an entry that has some.
  void replace_data(Value& journal) {
    Value entries = *journal.find("entries");
    Value& entry = entries.mutable_list()[below(entries.as_list().size())];
    Value input = *entry.find("input");
    for (const char* key : {"data", "result", "error"})
      if (input.find(key)) input.mutable_dict().set(key, junk());
    entry.mutable_dict().set("input", std::move(input));
    journal.mutable_dict().set("entries", std::move(entries));
  }
};

TEST(JournalFuzz, AMutatedJournalIsRefusedOrReadAsItStands) {
  const std::uint64_t seed = setting("RACE_SEED", 20261122);
  const std::uint64_t mutations = setting("RACE_MUTATIONS", 2'000);
  std::cout << "RACE_SEED=" << seed << " RACE_MUTATIONS=" << mutations << std::endl;
  std::vector<Value> journals{journal_json(small_journal())};
  for (std::uint64_t i = 0; i < 20; ++i) journals.push_back(journal_json(random_journal(seed + i, 12).first));
  std::size_t taken = 0;
  for (std::size_t i = 0; i < mutations && !HasFailure(); ++i) {
    SCOPED_TRACE("RACE_SEED=" + std::to_string(seed) + ", mutation " + std::to_string(i));
    const Value json = JournalMutator(seed + i).journal(journals);
    const auto read = read_journal(json);
    if (read) {
      ++taken;
      EXPECT_TRUE(read_journal(journal_json(*read)));
      EXPECT_EQ(journal_json(*read).find("entries")->as_list(), json.find("entries")->as_list());
    } else {
      EXPECT_FALSE(read.error().empty());
    }
  }
  std::cout << taken << " of " << mutations << " read" << std::endl;
  EXPECT_GT(taken, mutations / 10) << "too few mutations are harmless to say something about what is read";
  EXPECT_LT(taken, mutations / 2) << "too few mutations do harm";
}

}  // namespace
}  // namespace race::execution
