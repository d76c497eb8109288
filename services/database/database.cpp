#include "services/database/database.h"

#include "services/arguments.h"

namespace race::database {
namespace {

constexpr std::size_t kMostLogged = 100;  // more damage is in the answers alone

}  // namespace

Database::Database(Store store, services::ServiceHost& host)
    : TableComponent(operations(), host), store_(std::move(store)) {}

Expected<void> Database::reset(const Dict& values) {
  logged_.clear();
  return store_.replace_all(values);
}

void Database::get(const services::Call& call, const Dict& arguments) {
  answer(call, store_.get(arguments.find("key")->as_string()));
}

void Database::add(const services::Call& call, const Dict& arguments) {
  const Value& key = *arguments.find("key");
  answer(call, store_.put(key.as_string(), *arguments.find("value")).map([&] { return key; }));
}

void Database::remove(const services::Call& call, const Dict& arguments) {
  const Value& key = *arguments.find("key");
  answer(call, store_.remove(key.as_string()).map([&] { return key; }));
}

void Database::list(const services::Call& call, const Dict& arguments) {
  answer(call, store_.keys(arguments.find("prefix")->as_string()).map([](const std::vector<std::string>& keys) {
    return Value(List(keys.begin(), keys.end()));
  }));
}

void Database::answer(const services::Call& call, Expected<Value> value) {
  if (value) {
    host().result(call.id, std::move(*value));
  } else {
    if (value.error().code == ErrorCode::corrupt) log_damage(value.error());
    refuse(call, services::error_value(value.error()));
  }
}

void Database::log_damage(const Error& error) {
  if (logged_.size() < kMostLogged && logged_.insert(error.message).second) host().log(error.message);
}

void Database::refuse_arguments(const services::Call& call, const Error& error) {
  refuse(call, services::error_value(error));
}

}  // namespace race::database
