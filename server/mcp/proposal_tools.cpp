// Tools of proposals: changes of documents that wait for somebody who may make them.
#include "server/mcp/tool.h"

namespace race::server::mcp {

Outcome propose_document(const Context& context, const Dict& arguments) {
  const auto author = author_of(context);
  if (!author) return tl::unexpected(author.error());
  Target target{"documents", text_of(arguments, "name"), "proposals"};
  target.with("author", *author);
  Dict body;
  for (const char* name : {"document", "revision", "note"})
    if (const Value* value = arguments.find(name)) body.set(name, *value);
  return without(context.api.post(target, body), "proposed");
}

Outcome list_proposals(const Context& context, const Dict& arguments) {
  Target target{"proposals"};
  for (const char* name : {"document", "status", "after", "limit"}) target.with(name, arguments.find(name));
  return context.api.get(target);
}

Outcome read_proposal(const Context& context, const Dict& arguments) {
  return context.api.get(Target{"proposals", text_of(arguments, "id")});
}

Outcome withdraw_proposal(const Context& context, const Dict& arguments) {
  const auto author = author_of(context);
  if (!author) return tl::unexpected(author.error());
  Target target{"proposals", text_of(arguments, "id")};
  target.with("author", *author);
  return context.api.ask("DELETE", target);
}

}  // namespace race::server::mcp
