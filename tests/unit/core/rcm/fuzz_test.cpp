// Random documents: mutations of the valid ones of tests/conformance. Reading never crashes, a rejected document has a
// violation, an accepted one survives writing, formatting and translation. The seed of a failure is printed.
#include <gtest/gtest.h>

#include <random>

#include "core/rcm/document.h"
#include "core/rcm/ids.h"
#include "core/rcm/translate.h"
#include "tests/unit/core/rcm/cases.h"
#include "tests/unit/setting.h"

namespace race::rcm {
namespace {

class Mutator {
 public:
  Mutator(std::uint32_t seed, const std::vector<Value>& models) : random_(seed), models_(models) {}

  Value document() {
    Value out = models_[below(models_.size())];
    for (std::size_t i = 1 + below(3); i > 0; --i) mutate(out);
    return out;
  }

 private:
  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }

  /// Changes one place at some depth of `value`.
  void mutate(Value& value) {
    const bool inner = (value.is_list() && !value.as_list().empty()) || (value.is_dict() && !value.as_dict().empty());
    if (!inner || below(6) == 0) return replace(value);
    value.is_list() ? mutate_list(value.mutable_list()) : mutate_dict(value.mutable_dict());
  }

  void mutate_list(List& items) {
    const auto at = static_cast<std::ptrdiff_t>(below(items.size()));
    if (below(8) == 0) {
      items.erase(items.begin() + at);
    } else if (below(8) == 0) {
      items.insert(items.begin() + at, Value(items[below(items.size())]));
    } else {
      mutate(items[static_cast<std::size_t>(at)]);
    }
  }

  void mutate_dict(Dict& fields) {
    const auto entry = *(fields.begin() + static_cast<std::ptrdiff_t>(below(fields.size())));
    if (below(10) == 0) {
      fields.erase(entry.first.as_string());
    } else if (below(10) == 0) {
      fields.set(std::string_view(kWords[below(kWords.size())]), junk());
    } else {
      Value changed = entry.second;
      mutate(changed);
      fields.set(entry.first, std::move(changed));
    }
  }

  void replace(Value& value) {
    if (value.is_string() && below(2) == 0) {
      value = Value(kWords[below(kWords.size())]);
    } else if (value.is_string() && !value.as_string().empty() && below(2) == 0) {
      std::string text = value.as_string();
      text[below(text.size())] = static_cast<char>(' ' + static_cast<int>(below(95)));
      value = Value(text);
    } else {
      value = junk();
    }
  }

  Value junk() {
    switch (below(8)) {
      case 0:
        return Value();
      case 1:
        return true;
      case 2:
        return static_cast<std::int64_t>(random_()) - 5;
      case 3:
        return 0.25;
      case 4:
        return Value::unknown();
      case 5:
        return List{Value("A"), Value(Dict{{"state", "A"}})};
      case 6:
        return Dict{{"kind", "history"}, {"name", "p"}, {"when", "True"}, {"id", "p"}};
      default:
        return models_[below(models_.size())];
    }
  }

  static constexpr std::array<const char*, 23> kWords = {
      "state", "barrier", "A",    "B",    "P",  "first", "link",    "Grasp", "oracle", "keep", "par.f",   "to",
      "when",  "svc.t.x", "True", "meta", "id", "rcm",   "library", "from",  "value",  "x y",  "\xc3\xa9"};

  std::mt19937 random_;
  const std::vector<Value>& models_;
};

std::vector<Value> valid_models() {
  std::vector<Value> out;
  for (const auto& folder : cases(false)) out.push_back(parse_json(read_text(folder / "model.json")).value());
  return out;
}

/// Whether the document was accepted.
bool hold(const Value& json) {
  const auto document = read_document(json);
  if (!document) {
    EXPECT_FALSE(document.error().empty());
    return false;
  }
  EXPECT_EQ(read_document(write_document(*document)).value(), *document);
  EXPECT_EQ(read_document_text(format_document(*document)).value(), *document);
  EXPECT_TRUE(translate(*document).has_value());
  Document with_ids = *document;
  give_ids(with_ids);
  EXPECT_EQ(read_document_text(format_document(with_ids)).value(), with_ids);
  return true;
}

TEST(Fuzz, OfDocumentsNeverCrashesAndEachIsTakenOrHasAViolation) {
  const std::vector<Value> models = valid_models();
  const std::size_t seeds = sample(20'000);
  std::size_t taken = 0;
  for (std::uint32_t seed = 1; seed <= seeds && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    taken += hold(Mutator(seed, models).document()) ? 1U : 0U;
  }
  EXPECT_GT(taken, seeds / 20) << "too few mutations are harmless to say something about writing";
  EXPECT_LT(taken, seeds / 2) << "too few mutations do harm";
}

TEST(Fuzz, OfTextsNeverCrashes) {
  std::vector<std::string> texts;
  for (const auto& folder : cases(false)) texts.push_back(read_text(folder / "model.json"));
  std::mt19937 random(7);
  const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  for (int i = 0; i < 3'000; ++i) {
    std::string text = texts[below(texts.size())];
    for (std::size_t n = 1 + below(4); n > 0; --n) text[below(text.size())] = static_cast<char>(below(256));
    const auto document = read_document_text(text);
    ASSERT_TRUE(document || !document.error().empty()) << "seed 7, text " << i;
  }
}

}  // namespace
}  // namespace race::rcm
