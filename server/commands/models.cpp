// race models: the documents and drafts of a running server.
#include <cinttypes>
#include <cstdio>
#include <memory>

#include "core/value/json.h"
#include "server/commands/ask_documents.h"
#include "server/commands/command.h"

namespace race::server {
namespace {

std::string state_of(const DocumentSummary& document) {
  if (document.errors == 0) return "";
  if (document.errors > 200) return "  draft, more than 200 errors";
  return "  draft, " + std::to_string(document.errors) + (document.errors == 1 ? " error" : " errors");
}

int list(const ServerOptions& server) {
  const auto list = list_documents(server);
  if (!list) return list.error();
  if (server.json) {
    Dict answer{{"documents", list->json}};
    if (!list->damaged.empty()) answer.set("damaged", list->damaged);
    std::printf("%s\n", to_json(std::move(answer), 1).c_str());
  }
  for (const DocumentSummary& document : list->documents)
    if (!server.json)
      std::printf("%-24s  revision %" PRId64 "%s\n", in_one_line(document.name).c_str(), document.revision,
                  state_of(document).c_str());
  return report_damaged(server, *list);
}

std::function<int()> declare(Arguments& arguments) {
  const auto server = std::make_shared<ServerOptions>();
  server->declare(arguments, "prints the list as JSON (api/schemas/documents.json)");
  return [server] { return list(*server); };
}

}  // namespace

const Command kModels = {"models", "lists the documents and drafts of a running server", declare};

}  // namespace race::server
