// Component groups: what of a cell can run, and die, as a process of its own (`race serve --remote NAME`, `race service
// NAME`). The one table of them: adding a group is adding a row. Which of these services a cell has, and by which keys,
// says its file (cell_file.h).
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/value/expected.h"
#include "server/cell/cell_file.h"
#include "services/database/store.h"
#include "services/remote/process_host.h"
#include "services/remote/remotes.h"

namespace race::server {

/// What groups are made from, as of a cell (CellSetup).
struct GroupSetup {
  CellFile cell;
  std::string folder;    // of images
  std::string database;  // file of the database
};

struct ComponentGroup {
  /// A service that it may have, by type.
  struct Service {
    std::string_view type;
    const rsm::Service* model = nullptr;
  };
  std::string_view name;
  std::vector<Service> services;
  bool world = false;  // whether its process brings the world of the cell
  /// Makes the components in a process. Errors: those of the files.
  Expected<void> (*make)(const GroupSetup& setup, remote::ProcessHost& process);
};

std::span<const ComponentGroup> component_groups();
/// "cell, recognition, ..."
std::string component_group_names();
/// All that a process may bring: the groups, and services of its own (remote::kOwnGroup).
std::vector<std::string> groups_of_processes();
/// The group of this name; error `not_found` names those that there are.
Expected<const ComponentGroup*> find_component_group(std::string_view name);
/// Whether an account may have this group: of groups_of_processes(), or kLocal. Error `not_found` names those of
/// processes.
Expected<void> check_account_group(std::string_view name);

/// Those of its services that the cell has.
std::vector<remote::RemoteService> services_of(const ComponentGroup& group, const CellFile& cell);

/// The values in the file of the cell, frozen; none, if there is no such file. Errors: `io`, and those of the file.
Expected<Dict> start_values(const CellFile& cell);
/// Opens the database of a cell: start_values() whose keys it does not have are added to it. Errors: those, and of the
/// database.
Expected<database::Store> open_store(const CellFile& cell, const std::string& database);

}  // namespace race::server
