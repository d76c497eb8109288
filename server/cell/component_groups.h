// Component groups: what of a cell can run, and die, as a process of its own (`race serve --remote NAME`, `race service
// NAME`). The one table of them: adding a group is adding a row.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/value/expected.h"
#include "services/database/store.h"
#include "services/remote/process_host.h"
#include "services/remote/remotes.h"

namespace race::server {

/// What groups are made from, as of a cell (CellSetup).
struct GroupSetup {
  std::string folder;    // with scene.json, parts.json, database.json, images; what is absent is not there
  std::string database;  // file of the database
};

struct ComponentGroup {
  std::string_view name;
  std::vector<remote::RemoteService> services;
  bool world = false;  // whether its process brings the world of the cell
  /// Makes the components in a process. Errors: those of the files.
  Expected<void> (*make)(const GroupSetup& setup, remote::ProcessHost& process);
};

std::span<const ComponentGroup> component_groups();
/// "cell, recognition, ..."
std::string component_group_names();
std::vector<std::string> names_of_component_groups();
/// The group of this name; error `not_found` names those that there are.
Expected<const ComponentGroup*> find_component_group(std::string_view name);

/// The values of `folder`/database.json, frozen; none, if there is no such file. Errors: `io`, and those of the file.
Expected<Dict> start_values(const std::string& folder);
/// Opens the database of a cell: start_values() whose keys it does not have are added to it. Errors: those, and of the
/// database.
Expected<database::Store> open_store(const std::string& folder, const std::string& database);

}  // namespace race::server
