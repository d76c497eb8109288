// Runs of documents, from their start to their end.
#pragma once

#include <chrono>
#include <string_view>

#include "api/cpp/client/client.h"

namespace race::client {

/// The core (core.json) once its run is over: `status` is ended (with outcome and results), faulted (with fault) or
/// aborted. Errors: `timeout`: it is not over in time, and goes on; those of Client::follow() and Following::next().
Answered<Value> wait_for_end(const Client& client, std::string_view core, std::chrono::milliseconds timeout);

/// Creates a core of a document, with arguments of the root's parameters (a dict), starts it and waits for its end:
/// errors of all three. The core stays, for its derivations, until it is deleted.
Answered<Value> run_document(const Client& client, std::string_view document, const Value& arguments,
                             std::chrono::milliseconds timeout);

}  // namespace race::client
