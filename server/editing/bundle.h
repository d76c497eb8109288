// Bundle: a task in one file, with the interfaces of the services that it needs (api/schemas/bundle.json), and what a
// cell lacks to run it. Pure functions.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/rcm/model.h"
#include "core/rsm/model.h"
#include "core/value/expected.h"
#include "core/value/value.h"
#include "services/host/host.h"

namespace race::server {

/// What a task names of a service, in code or as one of its `services`.
struct NeededService {
  std::string type;  // empty: it does not say
  std::set<std::string> operations, events;
};
using NeededServices = std::map<std::string, NeededService>;  // by key

/// The services that a task needs; what it calls by `svc[...]` is known only when it runs. Errors: those of
/// rcm::translate() and of Program::build().
Checked<NeededServices> needed_services(const rcm::Document& document);

struct Bundle {
  static constexpr std::size_t kMostServices = 100;
  std::string name;                              // of the document
  Value document;                                // an object
  std::map<std::string, std::string> types;      // of services, by key, as its author had them; where it is known
  std::map<std::string, rsm::Service> services;  // the same of their RSMs
};

/// schemas/bundle.json, of a document as it is stored. What `here` does not have is named without an RSM.
Value bundle_json(const std::string& name, Value document, const NeededServices& needed,
                  const std::vector<services::ServiceStatus>& here);

/// Reads schemas/bundle.json; its document is not checked. Errors, with the field as path: those of parse_json(),
/// `type`, `missing`, `unknown_field`, `version`, `name` (the key of a service), `too_large` (more than kMostServices),
/// those of rsm::read_service().
Checked<Bundle> read_bundle(const std::string& text);

/// What the services of a cell lack to run the task of a bundle: for each that is not right its key as path and the
/// first of `not_found`: there is none of this key; `type`: it is another one than the
/// task or the bundle says; `missing`: it has not all operations and
/// events that the task names; `conflict`: an operation has other parameters than in the bundle; `unavailable`: its
/// process is not connected.
std::vector<Error> lacking(const NeededServices& needed, const Bundle& bundle,
                           const std::vector<services::ServiceStatus>& here);

}  // namespace race::server
