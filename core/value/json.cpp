#include "core/value/json.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

namespace race {
namespace {

// Builds a Value from nlohmann's SAX events, so that depth, duplicate keys and numbers out of range are checked while
// reading.
class Builder final : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit Builder(const JsonLimits& limits) : limits_(limits) {}

  bool null() override { return add(Value()); }
  bool boolean(bool v) override { return add(Value(v)); }
  bool number_integer(number_integer_t v) override { return add(Value(static_cast<std::int64_t>(v))); }
  bool number_unsigned(number_unsigned_t v) override {
    if (v > static_cast<number_unsigned_t>(std::numeric_limits<std::int64_t>::max())) return out_of_range();
    return add(Value(static_cast<std::int64_t>(v)));
  }
  bool number_float(number_float_t v, const string_t& text) override {
    // nlohmann reports integers that do not fit into 64 bits as doubles; their text has no `.` and no exponent.
    if (!std::isfinite(v) || text.find_first_of(".eE") == string_t::npos) return out_of_range();
    return add(Value(v));
  }
  bool string(string_t& v) override { return add(Value(std::move(v))); }
  bool binary(binary_t&) override { return fail(ErrorCode::json, "binary data"); }
  bool start_object(std::size_t) override { return open(Value(Dict())); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(Value(List())); }
  bool end_array() override { return close(); }
  bool key(string_t& v) override {
    if (stack_.back().find(v)) return fail(ErrorCode::json, "the key \"" + v + "\" is a duplicate in its object");
    keys_.back() = std::move(v);
    return true;
  }
  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& e) override {
    constexpr int kNumberOverflow = 406;  // of a double; nlohmann reads no further
    if (e.id == kNumberOverflow) return fail(ErrorCode::constant, kOutOfRange);
    std::string text = e.what();
    if (const auto start = text.find("] "); start != std::string::npos) text = text.substr(start + 2);
    // The part of the input that it quotes may be invalid UTF-8.
    text = text.substr(0, text.find("; last read"));
    return fail(ErrorCode::json, "not JSON at byte " + std::to_string(position) + ": " + text);
  }

  Value root;
  Error error{ErrorCode::json, "empty"};

 private:
  static constexpr const char* kOutOfRange = "a number is out of the range of a 64-bit integer or a double";

  bool fail(ErrorCode code, std::string message) {
    error = Error{code, std::move(message)};
    return false;
  }
  bool out_of_range() {
    if (limits_.keep_out_of_range) return add(Value::unknown());
    return fail(ErrorCode::constant, kOutOfRange);
  }
  bool open(Value container) {
    if (stack_.size() >= limits_.depth)
      return fail(ErrorCode::too_deep, "more than " + std::to_string(limits_.depth) + " levels of nesting");
    stack_.push_back(std::move(container));
    keys_.emplace_back();
    return true;
  }
  bool close() {
    Value done = std::move(stack_.back());
    stack_.pop_back();
    keys_.pop_back();
    return add(std::move(done));
  }
  bool add(Value v) {
    if (stack_.empty()) {
      root = std::move(v);
    } else if (stack_.back().is_list()) {
      stack_.back().mutable_list().push_back(std::move(v));
    } else {
      stack_.back().mutable_dict().set(Value(std::move(keys_.back())), std::move(v));
    }
    return true;
  }

  const JsonLimits& limits_;
  std::vector<Value> stack_;
  std::vector<std::string> keys_;
};

void write_number(double v, std::string& out) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, v).ptr;
  const std::string_view text(buffer, static_cast<std::size_t>(end - buffer));
  out += text;
  if (text.find_first_of(".e") == std::string_view::npos) out += ".0";
}

void write(const Value& value, int indent, int level, std::string& out) {
  const auto new_line = [&](int at) {
    if (indent < 0) return;
    out += '\n';
    out.append(static_cast<std::size_t>(indent * at), ' ');
  };
  switch (value.kind()) {
    case Value::Kind::unknown:
    case Value::Kind::null:
      out += "null";
      break;
    case Value::Kind::boolean:
      out += value.as_bool() ? "true" : "false";
      break;
    case Value::Kind::integer:
      out += std::to_string(value.as_integer());
      break;
    case Value::Kind::number:
      write_number(value.as_number(), out);
      break;
    case Value::Kind::string:
      append_json_string(value.as_string(), out);
      break;
    case Value::Kind::list: {
      out += '[';
      bool first = true;
      for (const Value& item : value.as_list()) {
        if (!first) out += ',';
        first = false;
        new_line(level + 1);
        write(item, indent, level + 1, out);
      }
      if (!first) new_line(level);
      out += ']';
      break;
    }
    case Value::Kind::dict: {
      out += '{';
      bool first = true;
      for (const auto& [key, item] : value.as_dict()) {
        if (!first) out += ',';
        first = false;
        new_line(level + 1);
        append_json_string(key.as_string(), out);
        out += indent < 0 ? ":" : ": ";
        write(item, indent, level + 1, out);
      }
      if (!first) new_line(level);
      out += '}';
      break;
    }
  }
}

}  // namespace

Expected<Value> parse_json(std::string_view text, const JsonLimits& limits) {
  if (text.size() > limits.bytes)
    return unexpected(ErrorCode::too_large, "more than " + std::to_string(limits.bytes) + " bytes");
  // nlohmann takes it for the end of the text.
  if (const auto end = text.find('\0'); end != std::string_view::npos)
    return unexpected(ErrorCode::json, "not JSON at byte " + std::to_string(end + 1) + ": a NUL");
  Builder builder(limits);
  if (!nlohmann::json::sax_parse(text, &builder)) return tl::unexpected(builder.error);
  return std::move(builder.root);
}

namespace {

/// Whether one of the next eight bytes may have to be escaped: is below space, or equals `"` or `\`; false for none of
/// those, true for some others.
bool has_escaped(const char* text) {
  constexpr std::uint64_t kOnes = 0x0101010101010101U, kHighs = 0x8080808080808080U;
  std::uint64_t word = 0;
  std::memcpy(&word, text, sizeof word);
  const auto has_zero = [](std::uint64_t w) { return (w - kOnes) & ~w & kHighs; };
  const std::uint64_t controls = (word - kOnes * 0x20U) & ~word & kHighs;
  return (controls | has_zero(word ^ (kOnes * '"')) | has_zero(word ^ (kOnes * '\\'))) != 0;
}

}  // namespace

void append_json_string(std::string_view text, std::string& out) {
  static constexpr char kHex[] = "0123456789abcdef";
  static constexpr auto kIsEscaped = [] {
    std::array<bool, 256> escaped{};
    for (std::size_t i = 0; i < 0x20; ++i) escaped[i] = true;
    escaped['"'] = escaped['\\'] = true;
    return escaped;
  }();
  out += '"';
  std::size_t written = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    while (i + sizeof(std::uint64_t) <= text.size() && !has_escaped(text.data() + i)) i += sizeof(std::uint64_t);
    if (i == text.size()) break;
    const char c = text[i];
    const auto byte = static_cast<unsigned char>(c);
    if (!kIsEscaped[byte]) continue;
    out += text.substr(written, i - written);
    written = i + 1;
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (c == '\n') {
      out += "\\n";
    } else if (c == '\t') {
      out += "\\t";
    } else if (c == '\r') {
      out += "\\r";
    } else {
      out += "\\u00";
      out += kHex[byte >> 4];
      out += kHex[byte & 15];
    }
  }
  out += text.substr(written);
  out += '"';
}

void append_json(const Value& value, std::string& out) { write(value, -1, 0, out); }

std::string to_json(const Value& value, int indent) {
  std::string out;
  write(value, indent, 0, out);
  return out;
}

}  // namespace race
