#include "tests/fuzz/support/json_mutator.h"

#include <algorithm>
#include <limits>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "core/language/primitives/utf8.h"
#include "core/value/json.h"
#include "core/value/value.h"

/// libFuzzer's own mutations: of bytes, with the dictionary and with what comparisons have looked for.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace race::fuzz {
namespace {

constexpr JsonLimits kLimits{.depth = 1000};
constexpr std::size_t kTextGrowth = 32;  // bytes that a string grows at most

class Mutation {
 public:
  explicit Mutation(unsigned seed) : random_(seed) {}

  bool one_in(std::size_t n) { return below(n) == 0; }
  std::size_t below(std::size_t n) { return random_() % n; }

  /// Changes one place at some depth.
  void change(Value& value) {
    if (value.is_list() && !value.as_list().empty() && !one_in(6)) return change_list(value.mutable_list());
    if (value.is_dict() && !value.as_dict().empty() && !one_in(6)) return change_dict(value.mutable_dict());
    if (value.is_string() && !one_in(4)) {
      value = change_text(value.as_string());
    } else if (value.is_integer() && !one_in(4)) {
      value = static_cast<std::int64_t>(static_cast<std::uint64_t>(value.as_integer()) + below(5) - 2);
    } else {
      value = other_value();
    }
  }

 private:
  void change_list(List& items) {
    const std::size_t at = below(items.size());
    const auto place = items.begin() + static_cast<std::ptrdiff_t>(at);
    switch (below(8)) {
      case 0:
        return void(items.erase(place));
      case 1:
        return void(items.insert(place, Value(items[below(items.size())])));
      case 2:
        return std::swap(items[at], items[below(items.size())]);
      default:
        return change(items[at]);
    }
  }

  // A copy of a field under another name brings parts of documents to places where they do not belong.
  void change_dict(Dict& fields) {
    const auto entry = *(fields.begin() + static_cast<std::ptrdiff_t>(below(fields.size())));
    switch (below(8)) {
      case 0:
        return void(fields.erase(entry.first.as_string()));
      case 1:
        return fields.set(change_text(entry.first.as_string()), entry.second);
      case 2: {
        const auto other = *(fields.begin() + static_cast<std::ptrdiff_t>(below(fields.size())));
        return fields.set(entry.first, other.second);
      }
      default: {
        Value changed = entry.second;
        change(changed);
        return fields.set(entry.first, std::move(changed));
      }
    }
  }

  std::string change_text(const std::string& text) {
    std::vector<std::uint8_t> bytes(text.begin(), text.end());
    bytes.resize(text.size() + kTextGrowth);
    const std::size_t size = LLVMFuzzerMutate(bytes.data(), text.size(), bytes.size());
    std::string changed(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    if (!language::utf8::valid(changed))
      std::ranges::replace_if(
          changed, [](char c) { return static_cast<signed char>(c) < 0; }, '?');
    return changed;
  }

  Value other_value() {
    constexpr auto kMost = std::numeric_limits<std::int64_t>::max();
    const std::vector<Value> values{nullptr, true,  0,      1,  -1,  kMost,  -kMost - 1, 0.5,
                                    -0.0,    1e308, 5e-324, "", "a", List{}, Dict{},     List{nullptr}};
    return values[below(values.size())];
  }

  std::minstd_rand random_;
};

// A mutated text in place of the old one, if it is JSON and fits.
std::string changed_json(std::string_view text, std::size_t most, Mutation& mutation) {
  auto json = parse_json(text, kLimits);
  if (!json) return {};
  mutation.change(*json);
  std::string changed = to_json(*json);
  return changed.size() <= most ? changed : std::string();
}

std::size_t store(const std::string& text, std::uint8_t* data) {
  std::ranges::copy(text, data);
  return text.size();
}

}  // namespace

std::size_t mutate_json(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  Mutation mutation(seed);
  if (!mutation.one_in(4)) {
    const std::string changed = changed_json({reinterpret_cast<char*>(data), size}, most, mutation);
    if (!changed.empty()) return store(changed, data);
  }
  return LLVMFuzzerMutate(data, size, most);
}

std::size_t mutate_json_lines(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  Mutation mutation(seed);
  const std::string text(reinterpret_cast<char*>(data), size);
  const std::size_t end = std::min(text.find('\n', mutation.below(size + 1)), size);
  const std::size_t before = end == 0 ? std::string::npos : text.rfind('\n', end - 1);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  const std::string rest = text.substr(end);
  if (!mutation.one_in(4) && begin + rest.size() < most) {
    const std::string changed =
        changed_json(std::string_view(text).substr(begin, end - begin), most - begin - rest.size(), mutation);
    if (!changed.empty()) return store(text.substr(0, begin) + changed + rest, data);
  }
  return LLVMFuzzerMutate(data, size, most);
}

}  // namespace race::fuzz
