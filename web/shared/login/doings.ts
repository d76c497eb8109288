// What people do on a page that changes something, and why an account may not: the one decision, by the server's own table.
import rights from "../../../api/rights.json";
import type { Me } from "../../generated/messages";
import type { Command } from "../run/controls";
import { refusalOfRight } from "./roles";

const { routes, messages } = rights;

/** What each needs. */
const kNeeds = {
  edit: messages.edit,
  store_document: routes["PUT /api/v1/documents/{name}"],
  branch_document: routes["POST /api/v1/documents/{name}/branch"],
  restore_document: routes["POST /api/v1/documents/{name}/restore"],
  delete_document: routes["DELETE /api/v1/documents/{name}"],
  accept_proposal: routes["POST /api/v1/proposals/{id}/accept"],
  decline_proposal: routes["POST /api/v1/proposals/{id}/decline"],
  withdraw_proposal: routes["DELETE /api/v1/proposals/{id}"],
  make_run: routes["POST /api/v1/cores"],
  start_run: routes["POST /api/v1/cores/{id}/start"],
  pause_run: routes["POST /api/v1/cores/{id}/pause"],
  resume_run: routes["POST /api/v1/cores/{id}/resume"],
  stop_run: routes["POST /api/v1/cores/{id}/stop"],
  step_run: routes["POST /api/v1/cores/{id}/step"],
  follow_edits: routes["PUT /api/v1/cores/{id}/live"],
  set_breakpoints: routes["PUT /api/v1/documents/{name}/breakpoints"],
  force: routes["POST /api/v1/cores/{id}/force"],
  import_run: routes["POST /api/v1/runs"],
  delete_run: routes["DELETE /api/v1/runs/{run}"],
  act_at_cell: routes["POST /api/v1/cell/person"],
  reset_cell: routes["POST /api/v1/cell/reset"],
  take_controls: routes["GET /api/v1/control/hold"],
  move_by_hand: routes["GET /api/v1/control/hold"],
  answer_control: routes["POST /api/v1/control/answer"],
  set_mode: routes["PUT /api/v1/control/mode"],
  set_speed: routes["GET /api/v1/control/hold"],
  call_service: routes["POST /api/v1/services/{service}/calls"],
  pair: routes["POST /api/v1/pairings"],
  confirm_edit: routes["POST /api/v1/cores/{id}/confirm_edit"],
  reset_stop: routes["POST /api/v1/stop/reset"],
  answer: messages.answer,
  be_display: messages.display,
  manage_accounts: routes["POST /api/v1/accounts"],
} as const satisfies Readonly<Record<string, string>>;

export type Doing = keyof typeof kNeeds;

/** Why the page of this person does not do it; nothing: it does. */
export const refusalTo = (me: Me | undefined, doing: Doing): string | undefined => refusalOfRight(me, kNeeds[doing]) ?? (doing === "answer_control" && me?.local === false ? "only a display at the cell hands the controls over" : undefined);

/** What the commands of a run do. */
export const doingOfCommand: Readonly<Record<Command, Doing>> = {
  start: "start_run", pause: "pause_run", resume: "resume_run", stop: "stop_run", again: "make_run",
  micro: "step_run", macro: "step_run", until: "step_run",
};

/** Groups of actions of the editor that edit the document. */
const kEdits: ReadonlySet<string> = new Set(["Edit", "Add", "Connect", "Structure", "Place", "Library"]);
/** Actions of these groups that change nothing. */
const kOnlyLook: ReadonlySet<string> = new Set(["copy", "properties", "state_editor", "select_all", "select_none"]);

/** Further actions of the editor and the debugger. */
const kActions: Readonly<Record<string, Doing>> = {
  rename: "edit", run: "make_run", pause: "pause_run", stop: "stop_run",
  live_start: "start_run", live_resume: "resume_run", live_micro: "step_run", live_macro: "step_run", follow: "follow_edits",
  breakpoint: "set_breakpoints", breakpoint_kind: "set_breakpoints", breakpoint_any_called: "set_breakpoints", breakpoint_any_fault: "set_breakpoints",
  step_mode: "step_run", step_into: "step_run", step_over: "step_run", step_out: "step_run", until_here: "step_run", force_port: "force",
  reset_cell: "reset_cell",
};

/** What an action does; nothing: it changes nothing. */
export function doingOfAction({ id, group }: { readonly id: string; readonly group: string }): Doing | undefined {
  if (Object.hasOwn(kActions, id)) return kActions[id];
  return kEdits.has(group) && !kOnlyLook.has(id) ? "edit" : undefined;
}

/** Why an action is not for this person; nothing: it is. */
export function refusalOfAction(me: Me | undefined, action: { readonly id: string; readonly group: string }): string | undefined {
  const doing = doingOfAction(action);
  return doing && refusalTo(me, doing);
}

/** Whether the account changes nothing at all: the page says so plainly. */
export const isReadOnly = (me: Me | undefined): boolean => (Object.keys(kNeeds) as readonly Doing[]).every((doing) => refusalTo(me, doing) !== undefined);
