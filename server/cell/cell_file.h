// CellFile: what a cell is, as `cell.json` of its folder says (api/schemas/cell.json): its files, the services that
// this program makes for it, those that processes are expected to bring, and who may bring more. A folder without it is
// a cell of all services that the program has and the folder has files for.
//
// Threads: any; a value that nobody changes.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/rsm/model.h"
#include "core/value/expected.h"

namespace race::server {

// Types of the services that this program makes.
inline constexpr std::string_view kRobotType = "robot";
inline constexpr std::string_view kGripperType = "gripper";
inline constexpr std::string_view kCameraType = "KinectDriver";
inline constexpr std::string_view kRecognitionType = "ObjectRecognition";
inline constexpr std::string_view kDatabaseType = "database";
inline constexpr std::string_view kTimerType = "timer";
inline constexpr std::string_view kDisplayType = "display";
inline constexpr std::string_view kAudioType = "audio";

/// Whether a file of a cell may name a service of this type.
bool is_known_type(std::string_view type);

struct CellFile {
  /// A service that this program makes; no type stands twice.
  struct Service {
    std::string key, type;
  };
  /// One that a process of somebody's own brings: it must be of this type and have this RSM.
  struct Awaited {
    std::string key, type;
    rsm::Service model;
  };

  std::string path;  // of the file; empty: there is none
  // Of its files; empty: the cell has none. Without a cell.json they have their usual names, and need not be there.
  std::string scene, parts, database;
  std::vector<Service> services;  // in this order
  std::vector<Awaited> expects;
  std::optional<std::set<std::string>> accounts;  // that may bring services; nothing: all of the group `own`

  /// The key of the service of this type, if the cell has one.
  std::optional<std::string> key_of(std::string_view type) const;
  /// Whether there is this file of the cell. Error `io`: that cannot be found out.
  Expected<bool> has(const std::string& file) const;
  /// A service lacks something: nothing is wrong if no file names it. Error `missing`.
  Expected<void> lacks(const std::string& key, const std::string& what) const;
};

/// Reads the cell of a folder; an empty one is none, without files. Errors, each with the file and the field
/// (`FILE: expects/lamp/rsm`) as path: `io`, `json`, `type`, `missing`, `unknown_field`, `version`, `name`,
/// `duplicate`, `not_found` (this program has no such service), `too_large`; those of rsm::read_service() of the RSMs
/// that it names.
Checked<CellFile> read_cell(const std::string& folder);

}  // namespace race::server
