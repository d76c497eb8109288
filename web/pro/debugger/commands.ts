// What the debugger can do, each once: for keys, menus, buttons and the palette, on the page of a run and of a document.
import { isAt, newBreakpoint } from "../../shared/debugger/breakpoints";
import { reasonAgainstForce } from "../../shared/debugger/force";
import { kOfPort, kOfState, whenTitles } from "../../shared/debugger/places";
import { stepBy, untilHere, type StepOrReason, type StepWay } from "../../shared/debugger/steps";
import { allowedBeside } from "../../shared/live/shownRun";
import { portAddress } from "../../shared/model/model";
import { stateAt } from "../../shared/model/modelTree";
import { allowed, type Command } from "../../shared/run/controls";
import type { DebugShortcut } from "../../shared/session/shortcuts";
import { commandable } from "../../shared/session/session";
import { attempt, api, session, view } from "../client";
import { editing } from "../edit/editing";
import { ask, type MenuEntry } from "../edit/prompt";
import { runTree } from "../live/runTree";
import { refusalOfActionNow } from "../login/rights";
import { command } from "../panels/startAsk";
import { changeBreakpoints } from "./breakpoints";
import { propose } from "./forcing";
import { kept } from "./kept";
import { placeOnScreen, selectionInRun, targetNow } from "./target";

export interface DebugCommand {
  readonly id: string;
  readonly name: string;
  readonly shortcut?: DebugShortcut;
  /** Why it cannot be done now; nothing: it can. */
  readonly when: () => string | undefined;
  readonly run: () => void;
}

const kNoTarget = "no state or port is selected";
const notHere = (): string | undefined => (kept().loaded ? undefined : "the breakpoints are not here yet");

/** The watched core, where this page moves it. */
function movable(command: Command): boolean {
  const edited = view.get().page === "edit" ? editing.get().document : undefined;
  return allowedBeside(commandable(session.get()), edited).has(command);
}

const toggling: DebugCommand = {
  id: "breakpoint", name: "Toggle breakpoint", shortcut: "breakpoint",
  when: () => (targetNow() === undefined ? kNoTarget : notHere()),
  run: () => {
    const target = targetNow();
    if (target !== undefined) changeBreakpoints({ type: "toggled", when: target.kind === "port" ? "fired" : "entered", where: target.where });
  },
};

const ofKind: DebugCommand = {
  id: "breakpoint_kind", name: "Breakpoint when …",
  when: () => (targetNow() === undefined ? kNoTarget : notHere()),
  run: () => {
    const target = targetNow();
    if (target === undefined) return;
    const entries = (target.kind === "port" ? kOfPort : kOfState).map((when): MenuEntry => {
      const isSet = kept().entries.some((entry) => isAt(entry, when, target.where));
      return { name: `${isSet ? "✓ " : ""}${whenTitles[when]}`, run: () => changeBreakpoints({ type: "toggled", when, where: target.where }) };
    });
    ask({ kind: "menu", label: `Breakpoint at ${target.name} when`, at: placeOnScreen(), entries });
  },
};

const ofTask = (when: "called" | "fault", name: string): DebugCommand => ({
  id: `breakpoint_any_${when}`, name, when: notHere, run: () => changeBreakpoints({ type: "added", breakpoint: newBreakpoint(when) }),
});

function step(found: StepOrReason): string | undefined {
  return "reason" in found ? found.reason : movable("until") ? undefined : "the run is not paused";
}

function take(found: StepOrReason): void {
  if (!("reason" in found)) command("until", found.request);
}

function byState(way: StepWay): StepOrReason {
  const [tree, active] = [runTree(), session.get().run?.active];
  return tree === undefined || active === undefined ? { reason: "no run is watched" } : stepBy(tree, active, selectionInRun(), way);
}

const stepping = (way: StepWay, name: string): DebugCommand => ({ id: `step_${way}`, name, shortcut: way, when: () => step(byState(way)), run: () => take(byState(way)) });

function toHere(): StepOrReason {
  const tree = runTree();
  return tree === undefined ? { reason: "no run is watched" } : untilHere(tree, selectionInRun());
}

const here: DebugCommand = { id: "until_here", name: "Run until here", shortcut: "until_here", when: () => step(toHere()), run: () => take(toHere()) };

/** Paused, it goes on by steps alone; a run that has not begun begins with its first step. */
const stepMode: DebugCommand = {
  id: "step_mode", name: "Step mode", shortcut: "step_mode",
  when: () => {
    const core = commandable(session.get());
    if (core === undefined) return "no run is watched";
    if (core.status === "ready") return core.paused ? "it is on: start the run, and it waits for steps" : undefined;
    return movable("pause") || movable("resume") ? undefined : "the run is over";
  },
  run: () => {
    const core = commandable(session.get());
    if (core?.status === "ready") void attempt(async () => void (await api.pause(core.id)));
    else command(allowed(core).has("pause") ? "pause" : "resume");
  },
};

/** The active state that is selected in the run, or that has the selected port. */
function activeState(): string | undefined {
  const selection = selectionInRun();
  const path = selection?.kind === "node" ? selection.path : undefined;
  return path !== undefined && session.get().run?.active.includes(path) === true ? path : undefined;
}

const leaving: DebugCommand = {
  id: "force_port", name: "Leave through port …",
  when: () => {
    if (session.get().past !== undefined) return "the past is shown";
    const path = activeState();
    const tree = runTree();
    if (path === undefined || tree === undefined) return "no active state of a run is selected";
    if (stateAt(tree, path)?.ports.length === 0) return "it has no ports";
    return reasonAgainstForce(commandable(session.get()));
  },
  run: () => {
    const [path, tree] = [activeState(), runTree()];
    const state = path === undefined || tree === undefined ? undefined : stateAt(tree, path);
    if (path === undefined || state === undefined) return;
    const entries = state.ports.map((port): MenuEntry => ({
      name: port.to === undefined ? `${port.name} (exits)` : `${port.name} → ${port.to}`, run: () => propose({ path, scope: "port", name: portAddress("", port).slice(1) }),
    }));
    ask({ kind: "menu", label: `Leave ${state.name} through`, at: placeOnScreen(), entries });
  },
};

/** First of all, what the account may not do, and what waits for a reset. */
const withRights = (command: DebugCommand): DebugCommand => ({ ...command, when: () => refusalOfActionNow({ id: command.id, group: "Debug" }) ?? command.when() });

const all: readonly DebugCommand[] = [
  toggling, ofKind, ofTask("called", "Breakpoint at any call"), ofTask("fault", "Breakpoint at any fault"),
  stepMode, stepping("into", "Step into"), stepping("over", "Step over"), stepping("out", "Step out"), here, leaving,
];

export const debugCommands: readonly DebugCommand[] = all.map(withRights);
