// The table of tools: what a model reads of each, and what does it.
#include <array>

#include "server/mcp/tools.h"

namespace race::server::mcp {
namespace {

constexpr Hints kReads{.reads = true, .idempotent = true};
constexpr Hints kAdds{};
constexpr Hints kChanges{.destroys = true};
constexpr Hints kEnds{.destroys = true, .idempotent = true};

constexpr std::array kTools = {
    Tool{"list_documents", "List documents",
         "The documents of the server (tasks: hierarchical state machines, RCM) by name, with the last revision "
         "and how many errors each has; 0: it can run. `next` of the answer is `after` of the next page.",
         R"("after": {"type": "string"}, "limit": {"type": "integer", "minimum": 1, "maximum": 1000})", "", kReads,
         list_documents},
    Tool{"read_document", "Read a document",
         "A document as it is edited, with its revision, who made that, and its errors. One that is larger than "
         "an answer is read as text, by pages: with `offset` 0, then with `next` of the answer before.",
         R"("name": {"type": "string", "minLength": 1},
            "revision": {"type": "integer", "minimum": 1, "description": "Absent: the last one"},
            "offset": {"type": "integer", "minimum": 0, "description": "Bytes of the JSON text"})",
         R"("name")", kReads, read_document},
    Tool{"list_skills", "List skills",
         "What a task can be put together from: library states of documents that are marked as skills, each with "
         "its document, title, parameters with units and ranges, results and ports; a port with `advice` is an "
         "error. A document that uses one copies it, and the library states that it links, into its own library. "
         "`next` of the answer is `after` of the next page.",
         R"("document": {"type": "string", "minLength": 1, "description": "Those of this document alone"},
            "after": {"type": "string"})",
         "", kReads, list_skills},
    Tool{"list_services", "List services",
         "The services (robot, gripper, camera, database and so on) with operations and events, parameters, units "
         "and ranges. `moves`: the operation may set something in motion; `safe`: it stops; `reads`: it changes "
         "nothing.",
         R"("service": {"type": "string", "minLength": 1, "description": "Everything about this one, states too"})", "",
         kReads, list_services},
    Tool{"check_document", "Check a document",
         "Whether a document is valid, or all its errors with path, code and message (200 at most). Nothing is "
         "stored. The server asks for the right to propose documents.",
         R"("document": {"type": "object"},
            "name": {"type": "string", "minLength": 1, "description": "Under which it would be stored"})",
         R"("document")", kReads, check_document},
    Tool{"propose_document", "Propose a change of a document",
         "Proposes a document, new or changed, to the people who may change documents: it is stored once one of "
         "them accepts it. Refused, with all its errors, if it is not valid. `revision`: that which it changes, "
         "the last one; absent: the document is new.",
         R"("name": {"type": "string", "minLength": 1}, "document": {"type": "object"},
            "revision": {"type": "integer", "minimum": 1},
            "note": {"type": "string", "description": "Why, for who decides"})",
         R"("name", "document")", kAdds, propose_document},
    Tool{"list_proposals", "List proposals",
         "Proposed changes of documents, the oldest first, and what has become of them: open, outdated (the "
         "document has changed since), accepted, declined (`reason`), withdrawn. `next` of the answer is `after` "
         "of the next page.",
         R"("document": {"type": "string", "minLength": 1},
            "status": {"type": "string", "enum": ["open", "outdated", "accepted", "declined", "withdrawn"]},
            "after": {"type": "string"}, "limit": {"type": "integer", "minimum": 1, "maximum": 100})",
         "", kReads, list_proposals},
    Tool{"read_proposal", "Read a proposal", "A proposal with its document, `proposed`, and what has become of it.",
         R"("id": {"type": "string", "minLength": 1})", R"("id")", kReads, read_proposal},
    Tool{"withdraw_proposal", "Withdraw a proposal",
         "Takes back a proposal of this account that nobody has decided about, such as one that is outdated or "
         "was a mistake.",
         R"("id": {"type": "string", "minLength": 1})", R"("id")", kEnds, withdraw_proposal},
    Tool{"change_document", "Change a document",
         "Stores a document as the next revision, whole or not at all, without asking anybody. `revision`: the "
         "last one that you have seen; if there is a later one, the answer is `conflict`. Without it there must "
         "be no document of this name.",
         R"("name": {"type": "string", "minLength": 1}, "document": {"type": "object"},
            "revision": {"type": "integer", "minimum": 1},
            "note": {"type": "string", "description": "Why it is changed"})",
         R"("name", "document")", kChanges, change_document, ToolKind::changes_documents},
    Tool{"list_cores", "List cores", "The cores of the server: runs that wait, go on, or are just over.", "", "",
         kReads, list_cores},
    Tool{"start_run", "Start a run",
         "Makes a core of a document and starts it. A ROBOT MAY MOVE: ask the person first, unless they have "
         "asked for this run. The rules of control are those for everybody: `stopped`: the cell is; `leased`: "
         "somebody else has its controls.",
         R"("document": {"type": "string", "minLength": 1},
            "arguments": {"type": "object", "description": "Of the parameters of its root, over their values"})",
         R"("document")", kChanges, start_run},
    Tool{"run_status", "Look at a run",
         "How a run stands: status, macro step, outcome, results, fault, why it is interrupted. With `values`, of "
         "a run that has a core, also which states and ports are active, and all values.",
         R"("run": {"type": "string", "minLength": 1}, "values": {"type": "boolean"})", R"("run")", kReads, run_status},
    Tool{"wait_for_run", "Wait for a run",
         "Waits until a run is over (`over`), or stands still: paused, interrupted, not started; at most "
         "`seconds` (30). Then tells how it stands; if it goes on, ask again. Can be cancelled, and tells its "
         "progress.",
         R"("run": {"type": "string", "minLength": 1},
            "seconds": {"type": "number", "minimum": 0, "maximum": 60})",
         R"("run")", kReads, wait_for_run},
    Tool{"stop_run", "Stop a run",
         "Ends a run between macro steps: it is aborted, and the safe operations of the services that it has "
         "called are called, so that what it moves stops.",
         R"("run": {"type": "string", "minLength": 1})", R"("run")", kEnds, stop_run, ToolKind::stops},
    Tool{"stop_cell", "STOP the cell",
         "Stops everything in the cell at once: all runs end, and nothing moves until a person resets the stop. "
         "Anybody may do this at any time; when in doubt, do. It is software, and no safety function.",
         "", "", kEnds, stop_cell, ToolKind::stops},
    Tool{"list_queue", "Look at the queue",
         "The runs that wait their turn, in order, and those before them: status, `core` (the run, once it has "
         "begun), and how it ended; why the queue is paused, if it is: then nothing begins until a person lets it "
         "go on. With `id`, one of them. `next` of the answer is `after` of the next page.",
         R"("id": {"type": "string", "minLength": 1},
            "after": {"type": "integer", "minimum": 1}, "limit": {"type": "integer", "minimum": 1, "maximum": 100})",
         "", kReads, list_queue},
    Tool{"queue_run", "Queue a run",
         "Queues a run of a document, which begins when all before it are over; at once, if there are none. A "
         "ROBOT MAY MOVE, now or later: ask the person first, unless they have asked for this run. If it faults, "
         "the queue pauses.",
         R"("document": {"type": "string", "minLength": 1},
            "arguments": {"type": "object", "description": "Of the parameters of its root, over their values"},
            "name": {"type": "string", "description": "For people"})",
         R"("document")", kChanges, queue_run},
    Tool{"cancel_queued_run", "Cancel a queued run",
         "Cancels a run that waits in the queue: it never begins. One that has begun is stopped with stop_run.",
         R"("id": {"type": "string", "minLength": 1})", R"("id")", kEnds, cancel_queued_run, ToolKind::stops},
    Tool{"list_runs", "List stored runs",
         "The stored runs, the newest first. `next` of the answer is `before` of the next page.",
         R"("document": {"type": "string", "minLength": 1}, "before": {"type": "integer", "minimum": 1},
            "limit": {"type": "integer", "minimum": 1, "maximum": 100})",
         "", kReads, list_runs},
    Tool{"read_derivations", "Read derivations",
         "What a run has done: the derivation of each macro step, by the rules of the semantics (race://rules). "
         "Without `from`, the last step. `next` of the answer, if there are more, is `from` of the next page.",
         R"("run": {"type": "string", "minLength": 1}, "from": {"type": "integer", "minimum": 1},
            "limit": {"type": "integer", "minimum": 1, "maximum": 100, "description": "Macro steps; 10"})",
         R"("run")", kReads, read_derivations},
    Tool{"explain_port", "Why a port fires or not",
         "Why a port fired or does not fire: its condition, the value of each part, and what blocks it. Instead "
         "of `port`, `state` with `action` or `parameter`: why an action is executed or not, or a parameter has "
         "its value. With `step` and `micro`: as things were then.",
         R"("run": {"type": "string", "minLength": 1},
            "port": {"type": "string", "description": "Such as Root/Pick/Grasp.success"},
            "state": {"type": "string", "description": "Such as Root/Pick/Grasp"},
            "action": {"type": "integer", "minimum": 0}, "parameter": {"type": "string"},
            "step": {"type": "integer", "minimum": 1}, "micro": {"type": "integer", "minimum": 0})",
         R"("run")", kReads, explain_port},
    Tool{"read_cell", "Look at the cell",
         "What is in the cell: robots, bodies, whether it is stopped, who has the controls, where each robot is "
         "now. With `objects`, also what the camera recognises in its next picture (poses as seen from the "
         "camera).",
         R"("objects": {"type": "boolean"})", "", kReads, read_cell},
    Tool{"call_service", "Call a service by hand",
         "Calls one operation of a service and gives its result. A ROBOT MAY MOVE: ask the person first. The "
         "rules of control are those for everybody: what moves needs the controls of the cell, which a program "
         "does not have, so use it for what reads, stops, or changes a database.",
         R"("service": {"type": "string", "minLength": 1}, "operation": {"type": "string", "minLength": 1},
            "args": {"type": "array", "description": "By position"},
            "kwargs": {"type": "object", "description": "By name"})",
         R"("service", "operation")", kChanges, call_service},
};

}  // namespace

std::span<const Tool> all_tools() { return kTools; }

}  // namespace race::server::mcp
