// The breakpoints of the person here at the document that is shown: kept on the server, and given to the cores that this page lets go.
import { applyBreakpoints, enabledOf, type BreakpointChange, type Entry } from "../../shared/debugger/breakpoints";
import type { Core, KeptBreakpoint } from "../../generated/messages";
import { runOfDocument } from "../../shared/live/shownRun";
import { isOver } from "../../shared/run/controls";
import { commandable } from "../../shared/session/session";
import { api, login, problem, session, view } from "../client";
import { refusalNow } from "../login/rights";
import { armRunsBy } from "../runCommands";
import { editing } from "../edit/editing";
import { listenToOwnName, ownName } from "../presence/ownName";
import { give } from "./giving";
import { kept, kNothingKept, setKept, type Owner } from "./kept";
import { isSaving, save } from "./saving";

/** The watched core gets them. */
function giveToCore(author: string, entries: readonly Entry[]): void {
  const core = runOfDocument(commandable(session.get()), kept().of?.document);
  if (core !== undefined && !isOver(core)) give(core, author, enabledOf(entries)).catch(problem);
}

/** Changes them here, on the server, and on the watched core. */
export function changeBreakpoints(change: BreakpointChange): void {
  const refusal = refusalNow("set_breakpoints");
  if (refusal !== undefined) {
    problem(`Not done: ${refusal}.`);
    return;
  }
  const { of, entries, loaded } = kept();
  const after = loaded ? applyBreakpoints(entries, change) : entries;
  if (of === undefined || after === entries) return;
  setKept({ entries: after });
  void save();
  giveToCore(of.author, after);
}

const load = ({ document, author }: Owner): Promise<readonly KeptBreakpoint[]> => api.breakpoints(document, author);

const entriesOf = (breakpoints: readonly KeptBreakpoint[], before: readonly Entry[] = []): readonly Entry[] => applyBreakpoints(before, { type: "loaded", breakpoints });

/** Gives a core the breakpoints of the person here; of one who may not set any, it gets none. */
export async function armCore(core: Core): Promise<void> {
  if (refusalNow("set_breakpoints") !== undefined) return;
  const { of, loaded, entries } = kept();
  const owner = { document: core.document, author: ownName() };
  const isHere = loaded && of?.document === owner.document && of.author === owner.author;
  await give(core, owner.author, enabledOf(isHere ? entries : entriesOf(await load(owner))));
}

/** `carried`: what the person had here under the name `before`; under a name that has none they stay. */
async function reload(carried: readonly Entry[] = [], before?: string): Promise<void> {
  const { of } = kept();
  if (of === undefined || isSaving()) return;
  const breakpoints = await load(of).catch(() => undefined);
  // Else it is asked again when the server is there, or the page gets the focus.
  if (breakpoints === undefined || kept().of !== of || isSaving()) return;
  const stay = breakpoints.length === 0 && carried.length > 0;
  const entries = stay ? carried : entriesOf(breakpoints, kept().entries);
  setKept({ loaded: true, entries });
  if (stay) void save();
  if (before === undefined) return;
  giveToCore(before, []);
  giveToCore(of.author, entries);
}

const documentShown = (): string | undefined => (view.get().page === "edit" ? editing.get().document : undefined) ?? session.get().document;

let connection = session.get().connection;

function follow(): void {
  const [document, author] = [documentShown(), ownName()];
  const { of, entries, unkept } = kept();
  const isBack = connection !== "open" && session.get().connection === "open";
  connection = session.get().connection;
  if (of?.document !== document || (of !== undefined && of.author !== author)) {
    setKept({ ...kNothingKept, of: document === undefined ? undefined : { document, author } });
    // Another account is another person, whose breakpoints are others.
    const isRenamed = of !== undefined && of.document === document && login.get().me?.name === undefined;
    void (isRenamed ? reload(entries, of.author) : reload());
  } else if (isBack) void (unkept === undefined ? reload() : save());
}

/** Follows the document that is shown, and the name of the person here. To be called once. */
export function followBreakpoints(): void {
  [session.listen, view.listen, editing.listen, listenToOwnName].forEach((listen) => listen(follow));
  addEventListener("focus", () => void reload());
  armRunsBy(armCore);
  follow();
}
