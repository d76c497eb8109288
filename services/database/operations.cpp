#include "services/database/database.h"
#include "services/types.h"

namespace race::database {

namespace types = services::types;

const services::OperationTable& Database::operations() {
  static const Value error = types::record({{"code", "string"}, {"message", "string"}});
  static const services::ParameterRow key = {.name = "key", .type = "string"};
  static const services::OperationTable table({
      .name = "database",
      .operations =
          {
              {.name = "get",
               .handler = &Database::get,
               .parameters = {key},
               .result = "any",
               .error = error,
               .reads = true,
               .doc = "The value stored under `key`; error `not_found`; `corrupt`: it is damaged."},
              {.name = "add",
               .handler = &Database::add,
               .parameters = {key, {.name = "value", .type = "any"}},
               .result = "string",
               .error = error,
               .doc = "Stores a pose, a transform or any other value under `key`, over an old one; answers the key; "
                      "error `storage`: the disk is full or fails."},
              {.name = "remove",
               .handler = &Database::remove,
               .parameters = {key},
               .result = "string",
               .error = error,
               .doc = "Forgets `key`; answers the key; error `not_found`."},
              {.name = "list",
               .handler = &Database::list,
               .parameters = {{.name = "prefix", .type = "string", .value = ""}},
               .result = types::list("string"),
               .error = error,
               .reads = true,
               .doc = "The keys that begin with `prefix`, sorted; error `corrupt`: a key is damaged."},
          },
      .states = {{"Ready", {}}},
      .init = "Ready",
      .transitions =
          {
              {.id = "get", .dst = "Ready", .operation = "get"},
              {.id = "add", .dst = "Ready", .operation = "add"},
              {.id = "remove", .dst = "Ready", .operation = "remove"},
              {.id = "list", .dst = "Ready", .operation = "list"},
          },
  });
  return table;
}

const rsm::Service& model() { return Database::operations().model(); }

}  // namespace race::database
