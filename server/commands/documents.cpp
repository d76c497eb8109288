// The commands on documents: translate and fmt.
#include <algorithm>
#include <cstdio>
#include <memory>

#include "core/rcm/document.h"
#include "core/rcm/ids.h"
#include "core/rcm/translate.h"
#include "core/value/json.h"
#include "server/commands/command.h"
#include "server/commands/input.h"
#include "server/store/files.h"

namespace race::server {
namespace {

tl::expected<rcm::Document, FileErrors> load(const std::string& path) {
  const auto text = read_input(path);
  if (!text) return tl::unexpected(FileErrors{path, {text.error()}});
  auto document = rcm::read_document_text(*text);
  if (!document) return tl::unexpected(FileErrors{path, std::move(document).error()});
  return std::move(*document);
}

// race translate MODEL: the native model, without links, oracles and `after`, and where each of its elements comes
// from.
int translate(const std::string& path) {
  const auto document = load(path);
  if (!document) return refuse(document.error());
  const auto native = rcm::translate(*document);
  if (!native) return refuse(FileErrors{path, native.error()});
  Dict origin;
  for (const auto& [element, from] : native->origin) origin.set(element, from);
  Dict out;
  out.set("rcm", 1);
  out.set("name", document->name);
  out.set("root", rcm::write_state(native->root));
  out.set("origin", std::move(origin));
  std::printf("%s\n", to_json(out, 2).c_str());
  return kExitOk;
}

// The document as a file should hold it, every element with an id.
tl::expected<std::string, FileErrors> formatted(const std::string& path, const std::string& text) {
  auto document = rcm::read_document_text(text);
  if (!document) return tl::unexpected(FileErrors{path, std::move(document).error()});
  rcm::give_ids(*document);
  auto written = rcm::write_document_text(*document);
  if (!written) return tl::unexpected(FileErrors{path, {std::move(written).error()}});
  return std::move(*written);
}

// race fmt MODEL... [--write]: the documents as files should hold them, on stdout or in place.
int format(const std::vector<std::string>& paths, bool write) {
  if (write && std::ranges::find(paths, kStandardInput) != paths.end())
    return refuse(Error{ErrorCode::not_accepted, "the standard input cannot be written", "--write"});
  for (const std::string& path : paths) {
    const auto old = read_input(path);
    if (!old) return refuse(FileErrors{path, {old.error()}});
    const auto text = formatted(path, *old);
    if (!text) return refuse(text.error());
    if (!write) {
      std::fwrite(text->data(), 1, text->size(), stdout);
      continue;
    }
    if (*text == *old) continue;
    if (auto replaced = replace_file(path, *text); !replaced) return refuse(replaced.error());
  }
  return kExitOk;
}

std::function<int()> declare_translate(Arguments& arguments) {
  const auto path = std::make_shared<std::string>();
  arguments.file("MODEL", *path);
  return [path] { return translate(*path); };
}

std::function<int()> declare_format(Arguments& arguments) {
  struct Options {
    std::vector<std::string> paths;
    bool write = false;
  };
  const auto options = std::make_shared<Options>();
  arguments.files("MODEL", options->paths);
  arguments.flag("--write", options->write, "writes the files instead of stdout");
  return [options] { return format(options->paths, options->write); };
}

}  // namespace

const Command kTranslate = {"translate", "prints the native model, without links, oracles and `after`",
                            declare_translate};
const Command kFmt = {"fmt", "prints documents as files should hold them, with ids, or writes them so", declare_format};

}  // namespace race::server
