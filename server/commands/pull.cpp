// race pull [DOCUMENT...] [--into FOLDER]: documents of a running server as files NAME.rcm.json, for keeping them in
// git. No file loses changes that the server does not have, unless `--force` says so (pulled_files.h).
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "core/rcm/ids.h"
#include "core/value/json.h"
#include "server/commands/ask_documents.h"
#include "server/commands/command.h"
#include "server/commands/document_file.h"
#include "server/commands/pulled_files.h"
#include "server/store/files.h"

namespace race::server {
namespace {

struct Options {
  std::vector<std::string> names;
  std::string into = ".";
  bool force = false, dry_run = false;
  ServerOptions server;
};

struct Names {
  std::vector<std::string> names;
  int code = kExitOk;  // kExitFindings: some documents of the server are damaged
};

class Pull {
 public:
  Pull(const Options& options, PulledFiles record)
      : options_(options), server_(options.server), record_(std::move(record)) {
    server_.json = false;  // one document on stdout: the report
  }

  // Gives the exit code, at least that of the names; what is pulled already stays if one of the next cannot be.
  int pull(const Names& wanted) {
    int code = wanted.code;
    for (const std::string& name : wanted.names) {
      code = std::max(code, pull_one(name));
      if (code == kExitBadInput) break;
    }
    if (!options_.dry_run)
      if (const auto written = record_.write(); !written) code = refuse(written.error());
    if (options_.server.json) std::printf("%s\n", to_json(Dict{{"files", std::move(report_)}}, 1).c_str());
    return code;
  }

 private:
  int pull_one(const std::string& name) {
    const auto found = get_document(server_, name);
    if (!found) return found.error();
    if (!*found) {
      refuse(Error{ErrorCode::not_found, "the server has no document of this name", name});
      return kExitFindings;
    }
    const ServerDocument& document = **found;
    const std::string path = options_.into + '/' + document_file_name(name);
    const PulledRevision last{document.revision, hash_of(document.text)};
    FileState state{std::nullopt, record_.find(name), last};
    if (std::filesystem::is_symlink(path))
      return refuse(Error{ErrorCode::conflict, "is a link, through which nothing is written", path});
    const auto is_there = file_exists(path);
    if (!is_there) return refuse(is_there.error());
    if (*is_there) {
      const auto file = read_document_file(path);
      if (!file) return refuse(file.error());
      state.file = hash_of(file->text);
    }
    return take(name, path, document, state);
  }

  int take(const std::string& name, const std::string& path, const ServerDocument& document, const FileState& state) {
    const PullStep step = pull_step(state);
    const bool is_changed = step == PullStep::keep || step == PullStep::conflict;
    if (step == PullStep::conflict && !options_.force) return refuse_conflict(name, path, state);
    if (step == PullStep::keep && !options_.force) {
      report(path, document.revision, "kept", "has changes that the server does not have");
      return kExitOk;
    }
    if (step == PullStep::write || is_changed) {
      if (!options_.dry_run) {
        const auto written = state.file ? replace_file(path, document.text) : write_file(path, document.text, 0644);
        if (!written) return refuse(written.error());
      }
      const std::string what = "revision " + std::to_string(document.revision);
      report(path, document.revision, "written", is_changed ? what + ", changes are dropped" : what);
    } else if (options_.server.json) {
      report(path, document.revision, "unchanged", "");
    }
    record_.set(name, *state.last);
    return kExitOk;
  }

  int refuse_conflict(const std::string& name, const std::string& path, const FileState& state) {
    const std::string base =
        state.base ? "changes of revision " + std::to_string(state.base->revision) : "another text";
    const std::string again = "`race pull --force " + name + into() + '`';
    refuse(Error{ErrorCode::conflict,
                 "the server has revision " + std::to_string(state.last->revision) + ", the file " + base +
                     ". Commit the file, then " + again + " and merge the two",
                 path});
    if (options_.server.json) report(path, state.last->revision, "conflict", "");
    return kExitFindings;
  }

  std::string into() const { return options_.into == "." ? "" : " --into " + options_.into; }

  // What is new, for people a line.
  void report(const std::string& path, std::int64_t revision, const char* result, const std::string& text) {
    if (options_.server.json)
      report_.push_back(Dict{{"file", path}, {"revision", revision}, {"result", result}});
    else
      std::printf("%s: %s\n", path.c_str(), text.c_str());
  }

  const Options& options_;
  ServerOptions server_;
  PulledFiles record_;
  List report_;
};

// Those of the command line, or all. A name becomes one of a file: whatever the server says, it is checked.
tl::expected<Names, int> find_names(const Options& options) {
  Names wanted{options.names};
  if (options.names.empty()) {
    const auto list = list_documents(options.server);
    if (!list) return tl::unexpected(list.error());
    for (const DocumentSummary& document : list->documents) wanted.names.push_back(document.name);
    wanted.code = report_damaged(options.server, *list);
  }
  for (const std::string& name : wanted.names)
    if (!rcm::is_id(name))
      return tl::unexpected(
          refuse(Error{ErrorCode::name, "a document's name is 1 to 64 of A-Z a-z 0-9 _ -", in_one_line(name)},
                 options.server.json));
  return wanted;
}

int run(const Options& options) {
  const auto names = find_names(options);
  if (!names) return names.error();
  std::error_code failed;
  if (!options.dry_run) std::filesystem::create_directories(options.into, failed);
  if (failed)
    return refuse(Error{ErrorCode::io, "cannot be made: " + failed.message(), options.into}, options.server.json);
  auto record = PulledFiles::read(options.into);
  if (!record) return refuse(record.error(), options.server.json);
  return Pull(options, std::move(*record)).pull(*names);
}

std::function<int()> declare(Arguments& arguments) {
  const auto options = std::make_shared<Options>();
  arguments.positionals("DOCUMENT", options->names, false, "of these names; else all");
  arguments.text("--into", "FOLDER", options->into, "where the files are");
  arguments.flag("--force", options->force, "drops changes of files that the server does not have");
  arguments.flag("--dry-run", options->dry_run, "says what would be written, and writes nothing");
  options->server.declare(arguments, "prints files, revisions and what became of them, as JSON");
  return [options] { return run(*options); };
}

}  // namespace

const Command kPull = {"pull", "writes documents of a running server to files NAME.rcm.json, for git", declare};

}  // namespace race::server
