#include "tests/client_cpp/given.h"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <utility>

namespace race::client {
namespace {

template <typename T>
T present(std::optional<T> value, std::string_view name) {
  if (!value) throw std::invalid_argument("`" + std::string(name) + "` is missing");
  return std::move(*value);
}

void require(bool holds, std::string_view name) {
  if (!holds) throw std::invalid_argument("`" + std::string(name) + "` is of another type");
}

}  // namespace

Given::Given(List positional, Dict named, std::optional<Value> body)
    : positional_(std::move(positional)), named_(std::move(named)), body_(std::move(body)) {}

std::optional<Value> Given::at_if(std::size_t position) const {
  positions_read_ = std::max(positions_read_, position + 1);
  return position < positional_.size() ? std::optional<Value>(positional_[position]) : std::nullopt;
}

const Value& Given::at(std::size_t position) const {
  if (!at_if(position)) throw std::invalid_argument("argument " + std::to_string(position) + " is missing");
  return positional_[position];
}

std::string Given::text_at(std::size_t position) const {
  require(at(position).is_string(), std::to_string(position));
  return at(position).as_string();
}

const Value* Given::find(std::string_view name) const {
  read_.emplace(name);
  return named_.find(name);
}

std::optional<std::string> Given::text_if(std::string_view name) const {
  const Value* const found = find(name);
  if (!found) return std::nullopt;
  require(found->is_string(), name);
  return found->as_string();
}

std::optional<std::int64_t> Given::integer_if(std::string_view name) const {
  const Value* const found = find(name);
  if (!found) return std::nullopt;
  require(found->is_integer(), name);
  return found->as_integer();
}

std::optional<bool> Given::flag_if(std::string_view name) const {
  const Value* const found = find(name);
  if (!found) return std::nullopt;
  require(found->is_bool(), name);
  return found->as_bool();
}

std::optional<double> Given::number_if(std::string_view name) const {
  const Value* const found = find(name);
  if (!found) return std::nullopt;
  require(found->is_numeric(), name);
  return found->to_double();
}

std::string Given::text(std::string_view name) const { return present(text_if(name), name); }
std::int64_t Given::integer(std::string_view name) const { return present(integer_if(name), name); }

const std::optional<Value>& Given::body_if() const {
  is_body_read_ = true;
  return body_;
}

const Value& Given::body() const {
  if (!body_if()) throw std::invalid_argument("the body is missing");
  return *body_;
}

void Given::close() const {
  for (const auto& [name, value] : named_)
    if (!read_.contains(name.as_string())) throw std::invalid_argument("this client has no `" + name.as_string() + "`");
  if (positions_read_ < positional_.size()) throw std::invalid_argument("this client has fewer arguments");
  if (body_ && !is_body_read_) throw std::invalid_argument("this client sends no body");
}

}  // namespace race::client
