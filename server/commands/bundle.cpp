// race bundle DOCUMENT and race install FILE: a task of a running server as one file, with the interfaces of the
// services that it needs, and from one (api/schemas/bundle.json).
#include <cinttypes>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "core/rcm/ids.h"
#include "core/value/fields.h"
#include "core/value/json.h"
#include "server/commands/ask_documents.h"
#include "server/commands/command.h"
#include "server/http/encode_part.h"
#include "server/store/files.h"

namespace race::server {
namespace {

struct BundleOptions {
  std::string document, out;
  bool force = false;
  ServerOptions server;
};

struct InstallOptions {
  std::string file, as, message;
  bool replace = false;
  ServerOptions server;
};

// A file that is there is kept, unless `--force` says otherwise.
Expected<void> write_bundle(const BundleOptions& options, const std::string& path, const std::string& text) {
  if (std::filesystem::is_symlink(path))
    return unexpected(ErrorCode::conflict, "is a link, through which nothing is written", path);
  ASSIGN_OR_RETURN(const bool is_there, file_exists(path));
  if (!is_there) return write_file(path, text, 0644);
  if (!options.force) return unexpected(ErrorCode::conflict, "is there already: --force replaces it", path);
  return replace_file(path, text);
}

int make(const BundleOptions& options) {
  if (!rcm::is_id(options.document))
    return refuse(
        Error{ErrorCode::name, "a document's name is 1 to 64 of A-Z a-z 0-9 _ -", in_one_line(options.document)},
        options.server.json);
  const auto bundle = ask_server(options.server, "GET", document_path(options.document) + "/bundle");
  if (!bundle) return bundle.error();
  const std::string path = options.out.empty() ? options.document + ".bundle.json" : options.out;
  if (const auto written = write_bundle(options, path, to_json(*bundle, 1) + '\n'); !written)
    return refuse(written.error(), options.server.json);
  if (options.server.json)
    std::printf("%s\n", to_json(Dict{{"file", path}}, 1).c_str());
  else
    std::printf("%s\n", path.c_str());
  return kExitOk;
}

Expected<Value> read_bundle_file(const std::string& path) {
  ASSIGN_OR_RETURN(const std::string text, read_file(path));
  auto bundle = parse_json(text);
  if (!bundle) bundle.error().path = path;
  return bundle;
}

// The name that the document is to have, as far as it can be known before the server has looked.
std::string name_of(const InstallOptions& options, const Value& bundle) {
  if (!options.as.empty() || !bundle.is_dict()) return options.as;
  const Value* name = bundle.as_dict().find("name");
  return name && name->is_string() ? name->as_string() : "";
}

// If-Match with the last revision, if there is one to be replaced.
tl::expected<HttpClient::Headers, int> condition(const InstallOptions& options, const Value& bundle) {
  const std::string name = name_of(options, bundle);
  if (!options.replace || !rcm::is_id(name)) return HttpClient::Headers{};
  const auto last = get_document(options.server, name);
  if (!last) return tl::unexpected(last.error());
  if (!*last) return HttpClient::Headers{};
  return HttpClient::Headers{{"If-Match", '"' + std::to_string((*last)->revision) + '"'}};
}

void print(const Value& installed) {
  std::vector<Error> errors;  // what is wrong in the answer of a server is left out: a list for people
  Fields fields(installed, "", "the answer", errors);
  const std::string name = fields.text("name").value_or("");
  std::printf("%s: revision %" PRId64 "\n", in_one_line(name).c_str(),
              fields.integer("revision", 1, INT64_MAX).value_or(0));
  for (const Value& each : fields.list("lacking")) {
    Fields lacking(each, "", "what is lacking", errors);
    const std::string key = lacking.text("path").value_or("");
    const std::string code = lacking.text("code").value_or("");
    std::printf("  lacks %s\n", in_one_line(key + ": " + code + ": " + lacking.text("message").value_or("")).c_str());
  }
}

int install(const InstallOptions& options) {
  const auto bundle = read_bundle_file(options.file);
  if (!bundle) return refuse(bundle.error(), options.server.json);
  const auto headers = condition(options, *bundle);
  if (!headers) return headers.error();
  std::string target = "/api/v1/bundles";
  if (!options.as.empty()) target += "?as=" + encode_part(options.as);
  if (!options.message.empty())
    target += (options.as.empty() ? "?message=" : "&message=") + encode_part(options.message);
  const auto answer = request_server(options.server, "POST", target, *bundle, *headers);
  if (!answer) return answer.error();
  if (!is_fine(*answer)) return refuse_answer(options.server, *answer, options.file);
  if (options.server.json)
    std::printf("%s\n", to_json(answer->body, 1).c_str());
  else
    print(answer->body);
  return kExitOk;
}

std::function<int()> declare_bundle(Arguments& arguments) {
  const auto options = std::make_shared<BundleOptions>();
  arguments.positional("DOCUMENT", options->document, "the task");
  arguments.text("--out", "FILE", options->out, "the file; else DOCUMENT.bundle.json");
  arguments.flag("--force", options->force, "replaces a file that is there");
  options->server.declare(arguments, "prints the name of the file, as JSON");
  return [options] { return make(*options); };
}

std::function<int()> declare_install(Arguments& arguments) {
  const auto options = std::make_shared<InstallOptions>();
  arguments.positional("FILE", options->file, "the bundle");
  arguments.text("--as", "NAME", options->as, "of the document; else that of the bundle");
  arguments.flag("--replace", options->replace, "also as the next revision of a document that is there");
  arguments.text("--message", "TEXT", options->message, "why, for the revision");
  options->server.declare(arguments, "prints what became of it as JSON (api/schemas/bundle_installed.json)");
  return [options] { return install(*options); };
}

}  // namespace

const Command kBundle = {"bundle", "writes a document of a running server to a file, with the services that it needs",
                         declare_bundle};
const Command kInstall = {"install", "stores the document of such a file, and says which services it lacks",
                          declare_install};

}  // namespace race::server
