// Database: the thesis' service that keeps poses, transforms and any other value between task executions, in one SQLite
// file. Stateless (4.1): every operation is accepted in every state and answered at once.
//
//   get(key)            -> the value; error `not_found`
//   add(key, value)     -> the key; an old value is replaced; errors `out_of_range`, `too_large`, `too_deep`
//   remove(key)         -> the key; error `not_found`
//   list(prefix = "")   -> the keys that begin with prefix, sorted
//
// Every operation: error `io` (the file fails), `type` or `missing` (an argument does not fit).
//
// Threads: its group's.
#pragma once

#include <memory>

#include "services/component.h"
#include "services/database/store.h"

namespace race::database {

/// The RSM of every database.
const rsm::Service& model();

class Database final : public services::Component {
 public:
  Database(Store store, services::ServiceHost& host);

  const rsm::Service& model() const override { return database::model(); }
  void call(const services::Call& call) override;

 private:
  Expected<Value> answer(const services::Call& call);

  Store store_;
  services::ServiceHost& host_;
};

}  // namespace race::database
