// The run bar: start, pause, step, stop, and the status of the run.
import type { Core } from "../../generated/messages";
import { allowedBeside } from "../../shared/live/shownRun";
import { goesOnMeanwhile, kEffects, primary, statusLook, type Command } from "../../shared/run/controls";
import { isInterrupted } from "../../shared/run/interruption";
import { keysOf, type Shortcut } from "../../shared/session/shortcuts";
import type { Drawer } from "../../shared/session/view";
import { commandable } from "../../shared/session/session";
import { useCore, useSession, useView, view } from "../client";
import { openDocument, useEditing } from "../edit/editing";
import { StepButtons } from "../debugger/StepButtons";
import { useRefusalOfCommand } from "../login/rights";
import { PastButtons } from "../past/PastButtons";
import { useIsGoing, useIsMaking } from "../../page/starting";
import { Icon, type IconName } from "./Icon";
import { usePersonStatus } from "./question";
import { StatusWord } from "./StatusWord";
import { command } from "./startAsk";

interface ButtonSpec {
  readonly command: Command;
  readonly name: string;
  readonly key: Shortcut;
  readonly icon: IconName;
  /** What services and robots do then. */
  readonly says?: string;
}

const firstButton: Readonly<Record<"start" | "resume" | "again", ButtonSpec>> = {
  start: { command: "start", name: "Start", key: "lead", icon: "play" },
  resume: { command: "resume", name: "Resume", key: "lead", icon: "play" },
  again: { command: "again", name: "Run again", key: "lead", icon: "again" },
};

const buttons: readonly ButtonSpec[] = [
  { command: "pause", name: "Pause", key: "pause", icon: "pause", says: kEffects.pause },
  { command: "micro", name: "Micro step", key: "micro", icon: "micro", says: kEffects.step },
  { command: "macro", name: "Macro step", key: "macro", icon: "macro", says: kEffects.step },
  { command: "stop", name: "Stop", key: "stop", icon: "stop", says: kEffects.stop },
];

export function RunBar() {
  const core = useCore();
  const page = useView((v) => v.page);
  const open = useEditing((now) => now.document);
  const edited = page === "edit" ? open : undefined;
  const commands = allowedBeside(useSession(commandable), edited);
  const lost = useSession((s) => s.connection === "lost");
  const past = useSession((s) => s.past !== undefined);
  const asks = usePersonStatus();
  const lead = primary(core);
  const first = firstButton[lead === "resume" || lead === "again" ? lead : "start"];
  return (
    <div className={`runbar${core !== undefined && isInterrupted(core) ? " is-interrupted" : ""}`} role="toolbar" aria-label="Run">
      {past && <span className="of-present">The present</span>}
      {[first, ...buttons].map((spec) => (
        // One button for the first command, so that it keeps the focus.
        <RunButton key={spec.key} spec={spec} taken={commands.has(spec.command)} />
      ))}
      <StepButtons />
      <PastButtons />
      {core !== undefined && (
        <p className={`run-status is-${asks !== undefined ? "paused" : statusLook(core)}`} role="status" aria-label="Run status" title={lost ? undefined : goesOnMeanwhile(core)}>
          {isInterrupted(core) ? <Icon name="interrupted" /> : <i aria-hidden="true" />}
          <StatusWord core={core} lost={lost} asks={asks} />
          <span>
            step {core.step}
            {core.micro > 0 ? `, micro step ${core.micro}` : ""}
            {core.waiting > 0 ? ` · ${core.waiting} waiting` : ""}
          </span>
        </p>
      )}
      {core !== undefined && <RunOf core={core} edited={edited} />}
      {page !== "edit" && <DrawerTabs />}
    </div>
  );
}

interface RunButtonProps {
  readonly spec: ButtonSpec;
  /** The run takes the command now. */
  readonly taken: boolean;
}

function RunButton({ spec, taken }: RunButtonProps) {
  const refusal = useRefusalOfCommand(spec.command);
  const [making, going] = [useIsMaking(), useIsGoing()];
  const isOnItsWay = spec.command === "again" ? making : (spec.command === "start" || spec.command === "resume") && going;
  const says = refusal ?? spec.says;
  return (
    <button
      type="button"
      className={`run-button run-${spec.command}`}
      disabled={!taken || isOnItsWay || refusal !== undefined}
      aria-label={spec.name}
      title={`${spec.name} (${keysOf(spec.key)})${says === undefined ? "" : `: ${says}`}`}
      aria-keyshortcuts={keysOf(spec.key)}
      onClick={() => command(spec.command)}
    >
      <Icon name={spec.icon} />
      <span>{spec.name}</span>
    </button>
  );
}

interface RunOfProps {
  readonly core: Core;
  /** The document that the page edits. */
  readonly edited: string | undefined;
}

/** Which run it is, and of what; with the way to the page that edits that. */
function RunOf({ core: { id, document, revision }, edited }: RunOfProps) {
  const isOther = edited !== undefined && edited !== document;
  return (
    <p className={isOther ? "run-of is-other" : "run-of"}>
      <span title={`Run ${id} of ${document}, which executes revision ${revision}`}>
        Run {id} of <b>{document}</b>, revision {revision}
        {isOther && ": not what you edit"}
      </span>
      {edited !== document && (
        <button type="button" className="link" title={`Edit ${document}`} onClick={() => openDocument(document)}>
          Edit
        </button>
      )}
    </p>
  );
}

const drawers: readonly { readonly drawer: Drawer; readonly name: string }[] = [
  { drawer: "derivation", name: "Derivation" },
  { drawer: "timeline", name: "Time line" },
  { drawer: "calls", name: "Calls and events" },
  { drawer: "log", name: "Log" },
  { drawer: "manual", name: "Manual" },
];

function DrawerTabs() {
  const open = useView((v) => v.drawer);
  return (
    <div className="tabs tabs-small" role="tablist" aria-label="Below">
      {drawers.map((entry) => (
        <button
          key={entry.drawer}
          type="button"
          role="tab"
          aria-selected={open === entry.drawer}
          onClick={() => view.dispatch({ type: "drawer", drawer: open === entry.drawer ? "closed" : entry.drawer })}
        >
          {entry.name}
        </button>
      ))}
    </div>
  );
}
