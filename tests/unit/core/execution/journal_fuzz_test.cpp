// Random mutations of journals: reading never crashes; what is read is written as it stood there.
#include <gtest/gtest.h>

#include <array>
#include <iostream>
#include <random>

#include "tests/unit/core/execution/journals.h"
#include "tests/unit/core/semantics/random_runs.h"

namespace race::execution {
namespace {

class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : random_(seed) {}

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
  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }

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

  // Changes one place at some depth of `value`.
  void mutate(Value& value) {
    const bool list = value.is_list() && !value.as_list().empty(), dict = value.is_dict() && !value.as_dict().empty();
    if ((!list && !dict) || below(8) == 0) {
      value = junk();
    } else if (list) {
      mutate_list(value.mutable_list());
    } else {
      mutate_dict(value.mutable_dict());
    }
  }

  void mutate_list(List& items) {
    const std::size_t at = below(items.size());
    if (below(8) == 0) return void(items.erase(items.begin() + static_cast<std::ptrdiff_t>(at)));
    if (below(8) == 0) return items.push_back(Value(items[at]));
    mutate(items[at]);
  }

  void mutate_dict(Dict& fields) {
    const auto entry = *(fields.begin() + static_cast<std::ptrdiff_t>(below(fields.size())));
    if (below(10) == 0) return void(fields.erase(entry.first.as_string()));
    if (below(10) == 0) return fields.set(kWords[below(kWords.size())], junk());
    Value changed = entry.second;
    mutate(changed);
    fields.set(entry.first, std::move(changed));
  }

  Value junk() {
    switch (below(7)) {
      case 0:
        return Value();
      case 1:
        return static_cast<std::int64_t>(below(9)) - 2;
      case 2:
        return 0.25;
      case 3:
        return Value::unknown();
      case 4:
        return List{Value("A"), Value(Dict{{"kind", "abort"}})};
      case 5:
        return Dict{{"kind", "event"}, {"service", "t"}, {"event", "e0"}, {"data", 1}};
      default:
        return kWords[below(kWords.size())];
    }
  }

  static constexpr std::array<const char*, 14> kWords = {
      "t", "e0", "o0", "start", "abort", "event", "response", "error", "result", "data", "link", "1", "x y", ""};
  std::mt19937_64 random_;
};

TEST(JournalFuzz, AMutatedJournalIsRefusedOrReadAsItStands) {
  const std::uint64_t seed = semantics::setting("RACE_SEED", 20261122);
  const std::uint64_t mutations = semantics::setting("RACE_MUTATIONS", 2'000);
  std::cout << "RACE_SEED=" << seed << " RACE_MUTATIONS=" << mutations << std::endl;
  std::vector<Value> journals{journal_json(small_journal())};
  for (std::uint64_t i = 0; i < 20; ++i) journals.push_back(journal_json(random_journal(seed + i, 12).first));
  std::size_t taken = 0;
  for (std::size_t i = 0; i < mutations && !HasFailure(); ++i) {
    SCOPED_TRACE("RACE_SEED=" + std::to_string(seed) + ", mutation " + std::to_string(i));
    const Value json = Mutator(seed + i).journal(journals);
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
