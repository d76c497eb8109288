#include "server/commands/pulled_files.h"

#include <limits>
#include <vector>

#include "core/rcm/ids.h"
#include "core/value/fields.h"
#include "core/value/json.h"
#include "server/store/files.h"

namespace race::server {
namespace {

constexpr std::size_t kHashLength = 64;
constexpr unsigned kForAll = 0644;

// The documents of the file. Nothing: it is none.
std::optional<std::map<std::string, PulledRevision>> read_documents(const Value& json) {
  std::vector<Error> errors;
  std::map<std::string, PulledRevision> documents;
  Fields fields(json, "", "the file", errors);
  fields.integer("race_pulled", 1, 1, kRequired);
  const Value* list = fields.find("documents", kRequired);
  fields.close();
  if (!errors.empty() || !list->is_dict()) return std::nullopt;
  for (const auto& [name, revision] : list->as_dict()) {
    Fields of_one(revision, "", "the revision", errors);
    const auto number = of_one.integer("revision", 1, std::numeric_limits<std::int64_t>::max(), kRequired);
    const auto hash = of_one.text("sha256", kRequired);
    of_one.close();
    if (!errors.empty() || !rcm::is_id(name.as_string()) || hash->size() != kHashLength) return std::nullopt;
    documents[name.as_string()] = {*number, *hash};
  }
  return documents;
}

}  // namespace

Expected<PulledFiles> PulledFiles::read(const std::string& folder) {
  PulledFiles files(folder + '/' + kFile);
  ASSIGN_OR_RETURN(const bool is_there, file_exists(files.path_));
  if (!is_there) return files;
  ASSIGN_OR_RETURN(const std::string text, read_file(files.path_));
  const auto json = parse_json(text);
  auto documents = json ? read_documents(*json) : std::nullopt;
  if (!documents)
    return unexpected(ErrorCode::not_accepted,
                      "does not say which revisions the files come from: take one side of a merge, or remove it, and "
                      "`race pull`",
                      files.path_);
  files.documents_ = std::move(*documents);
  return files;
}

std::optional<PulledRevision> PulledFiles::find(const std::string& name) const {
  const auto found = documents_.find(name);
  return found == documents_.end() ? std::nullopt : std::optional(found->second);
}

void PulledFiles::set(const std::string& name, const PulledRevision& revision) {
  PulledRevision& kept = documents_[name];
  changed_ = changed_ || kept != revision;
  kept = revision;
}

// A field a line: git merges changes of two documents.
Expected<void> PulledFiles::write() {
  if (!changed_) return {};
  Dict documents;
  for (const auto& [name, revision] : documents_)
    documents.set(name, Dict{{"revision", revision.revision}, {"sha256", revision.hash}});
  const Dict content{{"race_pulled", 1}, {"documents", std::move(documents)}};
  if (auto written = write_file(path_, to_json(content, 2) + '\n', kForAll); !written) return written;
  changed_ = false;
  return {};
}

PullStep pull_step(const FileState& state) {
  if (!state.file) return PullStep::write;
  if (*state.file == state.last->hash) return PullStep::unchanged;
  if (!state.base) return PullStep::conflict;
  if (*state.file == state.base->hash) return PullStep::write;
  return state.base == state.last ? PullStep::keep : PullStep::conflict;
}

PushStep push_step(const FileState& state) {
  if (!state.last) return state.base ? PushStep::removed : PushStep::create;
  if (*state.file == state.last->hash) return PushStep::unchanged;
  if (!state.base) return PushStep::unknown;
  return state.base == state.last ? PushStep::send : PushStep::conflict;
}

}  // namespace race::server
