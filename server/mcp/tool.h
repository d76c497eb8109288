// Tool: what a model can call: a row of tool_table.cpp, whose function is in one of the files *_tools.cpp.
#pragma once

#include <cstdint>
#include <string_view>

#include "core/value/value.h"
#include "server/mcp/context.h"

namespace race::server::mcp {

/// What clients may tell people before a call (ToolAnnotations).
struct Hints {
  bool reads = false;       // it changes nothing
  bool destroys = false;    // it changes or ends what is there, or moves a robot
  bool idempotent = false;  // the same call again changes nothing more
};

enum class ToolKind : std::uint8_t {
  usual,
  changes_documents,  // listed only for who may
  stops,              // its calls wait for no others
};

struct Tool {
  std::string_view name, title, description;
  /// The properties of the JSON Schema of its arguments (schema.h), and the names of those that are required, as JSON.
  std::string_view properties, required;
  Hints hints;
  /// Gives an object. The arguments fit the schema.
  Outcome (*call)(const Context& context, const Dict& arguments);
  ToolKind kind = ToolKind::usual;
};

// Documents (document_tools.cpp)
Outcome list_documents(const Context& context, const Dict& arguments);
Outcome read_document(const Context& context, const Dict& arguments);
Outcome check_document(const Context& context, const Dict& arguments);
Outcome change_document(const Context& context, const Dict& arguments);
// Proposals (proposal_tools.cpp)
Outcome propose_document(const Context& context, const Dict& arguments);
Outcome list_proposals(const Context& context, const Dict& arguments);
Outcome read_proposal(const Context& context, const Dict& arguments);
Outcome withdraw_proposal(const Context& context, const Dict& arguments);
// Skills and services (offer_tools.cpp)
Outcome list_skills(const Context& context, const Dict& arguments);
Outcome list_services(const Context& context, const Dict& arguments);
// Runs (run_tools.cpp)
Outcome list_cores(const Context& context, const Dict& arguments);
Outcome start_run(const Context& context, const Dict& arguments);
Outcome run_status(const Context& context, const Dict& arguments);
Outcome wait_for_run(const Context& context, const Dict& arguments);
Outcome stop_run(const Context& context, const Dict& arguments);
Outcome list_runs(const Context& context, const Dict& arguments);
// Runs that wait their turn (queue_tools.cpp)
Outcome list_queue(const Context& context, const Dict& arguments);
Outcome queue_run(const Context& context, const Dict& arguments);
Outcome cancel_queued_run(const Context& context, const Dict& arguments);
// What a run has done (derivation_tools.cpp)
Outcome read_derivations(const Context& context, const Dict& arguments);
Outcome explain_port(const Context& context, const Dict& arguments);
// The cell (cell_tools.cpp)
Outcome stop_cell(const Context& context, const Dict& arguments);
Outcome call_service(const Context& context, const Dict& arguments);
Outcome read_cell(const Context& context, const Dict& arguments);

/// A text of the arguments that its schema requires.
inline const std::string& text_of(const Dict& arguments, std::string_view name) {
  return arguments.find(name)->as_string();
}

/// As whom the account changes documents: as one of its pages, so that their history tells the two apart.
tl::expected<std::string, Problem> author_of(const Context& context);

/// Without a field of it, which the caller has.
Outcome without(Outcome answer, std::string_view field);

/// GET of a core or, if there is no such core, of the stored run of the same number; `below` is what follows in the
/// path, if anything, `query` adds to the target.
Outcome get_of_run(
    const Context& context, const std::string& run, std::string_view below = {},
    const std::function<void(Target&)>& query = [](Target&) {});

}  // namespace race::server::mcp
