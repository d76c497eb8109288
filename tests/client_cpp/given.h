// Given: the arguments of a step, by position and by name, and its body. What nobody reads is an error (close()), so
// that no step asks for something that is overlooked.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "core/value/value.h"

namespace race::client {

class Given {
 public:
  Given(List positional, Dict named, std::optional<Value> body = {});

  // Each throws std::invalid_argument if it is missing or of another type; `_if`: missing is nothing.
  const Value& at(std::size_t position) const;
  std::string text_at(std::size_t position) const;
  std::optional<Value> at_if(std::size_t position) const;
  std::string text(std::string_view name) const;
  std::optional<std::string> text_if(std::string_view name) const;
  std::int64_t integer(std::string_view name) const;
  std::optional<std::int64_t> integer_if(std::string_view name) const;
  std::optional<bool> flag_if(std::string_view name) const;
  std::optional<double> number_if(std::string_view name) const;
  const Value& body() const;
  const std::optional<Value>& body_if() const;

  /// Throws std::invalid_argument if something was not read.
  void close() const;

 private:
  const Value* find(std::string_view name) const;

  List positional_;
  Dict named_;
  std::optional<Value> body_;
  mutable std::set<std::string, std::less<>> read_;
  mutable std::size_t positions_read_ = 0;
  mutable bool is_body_read_ = false;
};

}  // namespace race::client
