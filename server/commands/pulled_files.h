// PulledFiles: which revision of the server each file of a folder comes from, in `.race-pulled.json` beside them. It
// goes into git with the files: whoever has a file then also has the revision that it is a change of, after a merge
// too.
//
// What may be overwritten is decided here, by comparing three texts: that of the file, that which the file was
// (`base`), and that of the server. A revision is told by its number and its text, so a server of another number line
// (another one, or one whose backup was restored) is noticed.
//
// Threads: one. Processes: the last one to write wins.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "core/value/expected.h"

namespace race::server {

struct PulledRevision {
  std::int64_t revision = 0;
  std::string hash;  // of the text (document_file.h, hash_of)
  bool operator==(const PulledRevision&) const = default;
};

class PulledFiles {
 public:
  static constexpr const char* kFile = ".race-pulled.json";

  /// That of a folder; without the file, of none. Errors, with the path: `io`, `too_large`; `not_accepted`: it is none,
  /// such as one with two sides of a merge.
  static Expected<PulledFiles> read(const std::string& folder);

  /// Nothing: the document was not pulled here.
  std::optional<PulledRevision> find(const std::string& name) const;
  void set(const std::string& name, const PulledRevision& revision);
  /// If something was set that was otherwise. Error `io`, with the path.
  Expected<void> write();

 private:
  explicit PulledFiles(std::string path) : path_(std::move(path)) {}
  std::string path_;
  std::map<std::string, PulledRevision> documents_;
  bool changed_ = false;
};

/// How a file stands to the server: hashes of texts.
struct FileState {
  std::optional<std::string> file;     // nothing: there is none
  std::optional<PulledRevision> base;  // nothing: it was not pulled
  std::optional<PulledRevision> last;  // of the server; nothing: it has no document of this name
};

enum class PullStep : std::uint8_t {
  unchanged,  // the file is the last revision
  write,      // the server has another one, and the file nothing that the server does not have
  keep,       // the file has changes, and the server nothing new
  conflict,   // both
};
/// Requires `last`.
PullStep pull_step(const FileState& state);

enum class PushStep : std::uint8_t {
  unchanged,  // the server has it
  send,       // a change of the last revision
  create,     // the server has no document of this name
  unknown,    // the server has one, and the file was not pulled
  removed,    // the server had one when it was pulled, and has none
  conflict,   // the server has another revision than the one that was changed
};
/// Requires `file`.
PushStep push_step(const FileState& state);

}  // namespace race::server
