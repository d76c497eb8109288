// What the roles may do on a page: by the table of the server, for commands of runs and for actions of the editor.
import { describe, expect, it } from "vitest";
import type { Me } from "../../generated/messages";
import { doingOfAction, doingOfCommand, isReadOnly, refusalOfAction, refusalTo, type Doing } from "../../shared/login/doings";
import { kRoles } from "../../shared/login/roles";

const of = (role: NonNullable<Me["role"]>): Me => ({ accounts: true, name: "eve", role });

/** The first role that may do it. */
const needs = (doing: Doing) => kRoles.find((role) => refusalTo(of(role), doing) === undefined);

describe("what is done on a page", () => {
  it("needs what the server asks for", () => {
    const expected: Readonly<Record<Doing, (typeof kRoles)[number]>> = {
      edit: "developer", store_document: "developer", branch_document: "developer", restore_document: "developer", delete_document: "developer",
      accept_proposal: "developer", decline_proposal: "developer", withdraw_proposal: "operator",
      make_run: "operator", start_run: "operator", pause_run: "operator", resume_run: "operator", stop_run: "operator",
      step_run: "developer", follow_edits: "developer", set_breakpoints: "developer", force: "developer", import_run: "developer", delete_run: "developer",
      act_at_cell: "operator", reset_cell: "operator", reset_stop: "operator", take_controls: "operator", move_by_hand: "operator", answer_control: "operator", set_mode: "operator", set_speed: "operator", call_service: "operator", pair: "operator", confirm_edit: "operator", answer: "operator", be_display: "operator", manage_accounts: "admin",
    };
    expect(Object.fromEntries((Object.keys(expected) as readonly Doing[]).map((doing) => [doing, needs(doing)]))).toEqual(expected);
  });

  it("is refused with the role that is needed, and not before it is known who asks", () => {
    expect(refusalTo(of("observer"), "edit")).toBe("this needs the role developer, and your account has the role observer");
    expect(refusalTo({ accounts: true }, "edit")).toBe("this needs the role developer, and nobody is logged in");
    expect(refusalTo(undefined, "edit")).toBeUndefined();
    expect(refusalTo({ ...of("operator"), local: false }, "answer_control")).toBe("only a display at the cell hands the controls over");
    expect(refusalTo({ ...of("operator"), local: true }, "answer_control")).toBeUndefined();
    expect(refusalTo({ accounts: false, role: "admin" }, "manage_accounts"), "without accounts, everybody may").toBeUndefined();
  });

  it("is nothing for an observer alone", () => {
    expect(kRoles.map((role) => isReadOnly(of(role)))).toEqual([true, false, false, false]);
    expect(isReadOnly(undefined)).toBe(false);
  });
});

describe("commands of a run", () => {
  it("are for operators, steps for developers", () => {
    const taken = (role: (typeof kRoles)[number]) => Object.entries(doingOfCommand).flatMap(([command, doing]) => (refusalTo(of(role), doing) === undefined ? [command] : []));
    expect(taken("observer")).toEqual([]);
    expect(taken("operator").sort()).toEqual(["again", "pause", "resume", "start", "stop"]);
    expect(taken("developer").sort()).toEqual(Object.keys(doingOfCommand).sort());
  });
});

describe("actions of the editor", () => {
  it("edit by their groups, but for those that only look", () => {
    const doing = (group: string, id: string) => doingOfAction({ group, id });
    expect([doing("Add", "add_state"), doing("Edit", "delete"), doing("Place", "note"), doing("Walk", "rename"), doing("Structure", "group")]).toEqual(Array(5).fill("edit"));
    expect([doing("Edit", "copy"), doing("Edit", "properties"), doing("Walk", "enter"), doing("Document", "save"), doing("Page", "search")]).toEqual(Array(5).fill(undefined));
    expect([doing("Document", "run"), doing("Page", "stop"), doing("Debug", "step_over"), doing("Debug", "force_port"), doing("Page", "reset_cell")]).toEqual(["make_run", "stop_run", "step_run", "force", "reset_cell"]);
  });

  it("are refused by what they do", () => {
    expect(refusalOfAction(of("operator"), { group: "Debug", id: "breakpoint" })).toContain("this needs the role developer");
    expect(refusalOfAction(of("operator"), { group: "Page", id: "pause" })).toBeUndefined();
    expect(refusalOfAction(of("observer"), { group: "Page", id: "search" })).toBeUndefined();
  });
});
