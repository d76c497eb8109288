// race push FILE...: files NAME.rcm.json to a running server, each as the next revision of the one that it is a change
// of (pulled_files.h). The work of others is never overwritten: the server takes it only if that is the last revision.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>

#include "core/value/json.h"
#include "server/commands/ask_documents.h"
#include "server/commands/command.h"
#include "server/commands/document_file.h"
#include "server/commands/pulled_files.h"
#include "server/http/encode_part.h"
#include "server/store/files.h"

namespace race::server {
namespace {

struct Options {
  std::vector<std::string> paths;
  std::string message;
  bool is_new = false, draft = false, dry_run = false;
  ServerOptions server;
};

struct Pushed {
  std::string path, name, folder;
  DocumentFile file;
};

class Push {
 public:
  explicit Push(const Options& options) : options_(options), server_(options.server) {
    server_.json = false;  // one document on stdout: the report
  }

  // All that is wrong in the files and their folders. Nothing is sent then.
  std::vector<FileErrors> read() {
    std::vector<FileErrors> wrong;
    for (const std::string& path : options_.paths)
      if (auto added = add(path); !added) wrong.push_back({"", {std::move(added).error()}});
    return wrong;
  }

  // Gives the exit code; what is pushed already stays if one of the next cannot be.
  int push() {
    int code = kExitOk;
    for (const Pushed& each : files_) {
      code = std::max(code, push_one(each));
      if (code == kExitBadInput) break;
    }
    if (options_.server.json) std::printf("%s\n", to_json(Dict{{"files", std::move(report_)}}, 1).c_str());
    return code;
  }

 private:
  Expected<void> add(const std::string& path) {
    ASSIGN_OR_RETURN(std::string name, document_name_of(path));
    ASSIGN_OR_RETURN(DocumentFile file, read_document_file(path));
    if (!file.document) return tl::unexpected(file.document.error());
    if (!file.document->is_dict()) return unexpected(ErrorCode::type, "must be an object", path);
    if (std::ranges::find(files_, name, &Pushed::name) != files_.end())
      return unexpected(ErrorCode::duplicate, "the document " + quote(name) + " stands twice", path);
    std::string folder = std::filesystem::path(path).parent_path();
    if (folder.empty()) folder = ".";
    if (!records_.contains(folder)) {
      ASSIGN_OR_RETURN(PulledFiles record, PulledFiles::read(folder));
      records_.emplace(folder, std::move(record));
    }
    files_.push_back({path, std::move(name), std::move(folder), std::move(file)});
    return {};
  }

  int push_one(const Pushed& pushed) {
    const auto found = get_document(server_, pushed.name);
    if (!found) return found.error();
    FileState state{hash_of(pushed.file.text), records_.at(pushed.folder).find(pushed.name), std::nullopt};
    if (*found) state.last = PulledRevision{(*found)->revision, hash_of((*found)->text)};
    switch (push_step(state)) {
      case PushStep::unchanged:
        report(pushed, state.last->revision, "unchanged", "the server has it");
        return options_.dry_run ? kExitOk : keep(pushed, *state.last);
      case PushStep::send:
        return send(pushed, {{"If-Match", '"' + std::to_string(state.base->revision) + '"'}});
      case PushStep::create:
        if (options_.is_new) return send(pushed, {{"If-None-Match", "*"}});
        return refuse_one(pushed, ErrorCode::not_found, "the server has no such document: `race push --new` makes it");
      case PushStep::removed:
        if (options_.is_new) return send(pushed, {{"If-None-Match", "*"}});
        return refuse_one(
            pushed, ErrorCode::conflict,
            "the document was removed at the server since it was pulled: `race push --new` makes it again");
      case PushStep::unknown:
        return refuse_conflict(pushed, "the server has another document of this name, which was not pulled here");
      case PushStep::conflict:
        break;
    }
    return refuse_conflict(pushed, "the server has revision " + std::to_string(state.last->revision) +
                                       ", the file changes of revision " + std::to_string(state.base->revision));
  }

  int send(const Pushed& pushed, const HttpClient::Headers& headers) {
    if (options_.dry_run) {
      report(pushed, std::nullopt, "pushed", "would be pushed");
      return kExitOk;
    }
    std::string query = options_.draft ? "?draft=true" : "";
    if (!options_.message.empty()) query += (query.empty() ? "?message=" : "&message=") + encode_part(options_.message);
    const auto answer =
        request_server(server_, "PUT", document_path(pushed.name) + query, *pushed.file.document, headers);
    if (!answer) return answer.error();
    if (answer->status == 412 || answer->status == 409)
      return refuse_conflict(pushed, "somebody else was faster: the server has another revision");
    if (!is_fine(*answer)) {
      add_refusal(pushed, "refused");
      return refuse_answer(server_, *answer, pushed.path);
    }
    const auto document = read_document_entry(answer->body);
    if (!document) return refuse(Error{document.error().code, document.error().message, options_.server.url});
    report(pushed, document->revision, "pushed", "revision " + std::to_string(document->revision));
    const int written = write_back(pushed, document->text);
    const int kept = keep(pushed, {document->revision, hash_of(document->text)});
    return std::max(written, kept);
  }

  // What is stored has ids, and its fields in their order: the file gets them, unless somebody has changed it
  // meanwhile.
  static int write_back(const Pushed& pushed, const std::string& text) {
    if (pushed.file.bytes == text) return kExitOk;
    const auto now = read_file(pushed.path);
    if (!now || *now != pushed.file.bytes) return kExitOk;
    const auto written = replace_file(pushed.path, text);
    return written ? kExitOk : refuse(written.error());
  }

  // After each file: whatever comes next, this one is known.
  int keep(const Pushed& pushed, const PulledRevision& revision) {
    PulledFiles& record = records_.at(pushed.folder);
    record.set(pushed.name, revision);
    const auto written = record.write();
    return written ? kExitOk : refuse(written.error());
  }

  static std::string merge_of(const Pushed& pushed) {
    return "Commit the file, then `race pull --force " + pushed.name +
           (pushed.folder == "." ? "" : " --into " + pushed.folder) + "`, merge the two, and push again";
  }

  int refuse_conflict(const Pushed& pushed, const std::string& why) {
    return refuse_one(pushed, ErrorCode::conflict, why + ". " + merge_of(pushed));
  }

  int refuse_one(const Pushed& pushed, ErrorCode code, std::string message) {
    refuse(Error{code, std::move(message), pushed.path});
    add_refusal(pushed, race::name(code));
    return kExitFindings;
  }

  void add_refusal(const Pushed& pushed, std::string_view why) {
    report_.push_back(Dict{{"file", pushed.path}, {"result", why}});
  }

  // No revision: it is not known before it is stored.
  void report(const Pushed& pushed, std::optional<std::int64_t> revision, const char* result, const std::string& text) {
    if (!options_.server.json) {
      std::printf("%s: %s\n", pushed.path.c_str(), text.c_str());
      return;
    }
    Dict each{{"file", pushed.path}, {"result", result}};
    if (revision) each.set("revision", *revision);
    report_.push_back(std::move(each));
  }

  const Options& options_;
  ServerOptions server_;
  std::vector<Pushed> files_;
  std::map<std::string, PulledFiles> records_;  // by folder
  List report_;
};

int run(const Options& options) {
  Push push(options);
  if (const auto wrong = push.read(); !wrong.empty()) return refuse(wrong, options.server.json);
  return push.push();
}

std::function<int()> declare(Arguments& arguments) {
  const auto options = std::make_shared<Options>();
  arguments.positionals("FILE", options->paths, true);
  arguments.flag("--new", options->is_new, "of documents that the server does not have: makes them");
  arguments.flag("--draft", options->draft, "stores also what has violations");
  arguments.text("--message", "TEXT", options->message, "why it was changed, for the list of revisions");
  arguments.flag("--dry-run", options->dry_run, "says what would be sent, and sends nothing");
  options->server.declare(arguments, "prints files, revisions and what became of them, as JSON");
  return [options] { return run(*options); };
}

}  // namespace

const Command kPush = {"push", "sends files NAME.rcm.json that were pulled and changed to a running server", declare};

}  // namespace race::server
