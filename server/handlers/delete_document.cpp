// DELETE /api/v1/documents/{name}: removes a document with all its revisions. What executes it keeps it.
#include "server/editing/editing.h"
#include "server/execution/cores.h"
#include "server/handlers/handlers.h"
#include "server/handlers/preconditions.h"
#include "server/http/refusal.h"
#include "server/store/boot_list.h"

namespace race::server {
namespace {

/// Error `conflict`: a core executes it, or may, or the server starts it when it begins.
Expected<void> check_unused(const std::string& name, const Cores& cores, BootList& boot) {
  for (const auto& core : cores.all()) {
    const Value info = core->info();
    if (info.find("document")->as_string() == name && !is_over(info))
      return unexpected(ErrorCode::conflict, "core " + core->id() + " has it; stop the core or delete it", name);
  }
  ASSIGN_OR_RETURN(const auto entries, boot.get());
  for (const BootEntry& entry : entries)
    if (entry.document == name) return unexpected(ErrorCode::conflict, "the boot list has it; take it out first", name);
  return {};
}

}  // namespace

Handled delete_document(const Request& request, Editing& editing, Cores& cores, BootList& boot) {
  const std::string& name = request.parameters.at("name");
  const auto seen = if_match(request);
  if (!seen) return failed(seen.error());
  if (auto unused = check_unused(name, cores, boot); !unused) return failed(std::move(unused).error());
  const auto removed = editing.remove(name, *seen);
  if (!removed && removed.error().code == ErrorCode::conflict) return refusal(412, std::vector<Error>{removed.error()});
  if (!removed) return failed(removed.error());
  return ok(Dict{{"removed", name}});
}

}  // namespace race::server
