// Database: the thesis' service that keeps poses, transforms and any other value between task executions, in one SQLite
// file. Stateless (4.1): every operation is accepted in every state and answered at once.
//
//   get(key)            -> the value; error `not_found`
//   add(key, value)     -> the key; an old value is replaced; errors `out_of_range`, `too_large`, `too_deep`
//   remove(key)         -> the key; error `not_found`
//   list(prefix = "")   -> the keys that begin with prefix, sorted
//
// Every operation: error `storage` (the disk is full or fails; nothing is changed), `io` (the file fails), `type` or
// `missing` (an argument does not fit). What is damaged: `corrupt` (store.h).
//
// Threads: its group's.
#pragma once

#include <set>
#include <string>

#include "services/database/store.h"
#include "services/table_component.h"

namespace race::database {

/// The RSM of every database.
const rsm::Service& model();

class Database final : public services::TableComponent {
 public:
  Database(Store store, services::ServiceHost& host);

  static const services::OperationTable& operations();
  /// These become its only values. Errors: Store::replace_all().
  Expected<void> reset(const Dict& values);

 private:
  void get(const services::Call& call, const Dict& arguments);
  void add(const services::Call& call, const Dict& arguments);
  void remove(const services::Call& call, const Dict& arguments);
  void list(const services::Call& call, const Dict& arguments);
  void answer(const services::Call& call, Expected<Value> value);
  void log_damage(const Error& error);
  void refuse_arguments(const services::Call& call, const Error& error) override;

  Store store_;
  std::set<std::string> logged_;  // damage, each once: a task may ask for a value again and again
};

}  // namespace race::database
