// What a test runs: the document with its root, and the services as the test has them.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/rcm/model.h"
#include "core/rsm/model.h"
#include "core/semantics/program.h"
#include "core/value/expected.h"
#include "server/model_tests/test_file.h"

namespace race::server {

using Interfaces = std::map<std::string, rsm::Service>;  // by key after `svc.`

/// The state of this name of the library as the root of its own task: what its links would compute (`from`) must be
/// given as arguments. Error `not_found`: the library has none.
Expected<rcm::Document> with_root(const rcm::Document& document, const std::string& state);

/// What a mock's script lists that its RSM does not have, or never answers: `not_found` for operations and events,
/// `type` for data, `constant` for an error that the operation never answers with, `missing`: the RSM has no states.
void check_mock(const MockScript& script, const rsm::Service& model, const std::string& path,
                std::vector<Error>& errors);

/// What a test names that the program and the services do not have: `not_found` for ports, calls and results,
/// `unknown_name` for arguments, `missing` for arguments that the root needs.
void check_test(const ModelTest& test, const semantics::Program& program, const Interfaces& services,
                const std::string& path, std::vector<Error>& errors);

}  // namespace race::server
