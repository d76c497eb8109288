// What makes a run, lets it begin and moves it on: each command of the run bar, the keys and the menus ends here.
import type { Core, StepRequest } from "../generated/messages";
import type { ExactArguments } from "../shared/api";
import { runParameters, type ExactDocument, type RunParameter } from "../shared/arguments/parameters";
import { readExact } from "../shared/edit/exact";
import type { Command, UntilRequest } from "../shared/run/controls";
import { watchedCore } from "../shared/session/session";
import { api, problem, session, view, sourceOf, watch } from "./client";
import { isSupervised } from "../control/supervised";
import { goOnce, makeOnce } from "../page/starting";

/** What a run gets before this page lets it go on. */
let arm: (core: Core) => Promise<void> = () => Promise.resolve();
/** To be called once. */
export function armRunsBy(by: (core: Core) => Promise<void>): void {
  arm = by;
}

/** Makes a core of a document, watches it (no longer the document, if that is being edited), and starts it if asked. Throws what the server refuses. */
export async function makeRun(document: string, start: boolean, args: ExactArguments): Promise<Core> {
  const core = await api.createCore(document, args);
  session.dispatch({ type: "update", update: { type: "core", core } });
  watch(core.id);
  if (view.get().page === "edit") view.dispatch({ type: "page", page: "task" });
  await arm(core);
  if (start) await api.start(core.id, isSupervised());
  return core;
}

/** The parameters of a run of the document, as it is now. Throws what the server refuses. */
export async function parametersOf(document: string): Promise<readonly RunParameter[]> {
  const entry = readExact(await api.documentText(document)) as unknown as { readonly document: ExactDocument };
  return runParameters(entry.document);
}

/** Carries a command out on the watched core. */
export async function run(command: Command, until?: UntilRequest): Promise<void> {
  const core = watchedCore(session.get());
  if (core === undefined) return;
  try {
    switch (command) {
      case "start":
      case "resume":
        await goOnce(async () => {
          await arm(core);
          await api[command](core.id, isSupervised());
        });
        return;
      case "pause":
      case "stop":
        await api[command](core.id);
        return;
      case "again":
        await makeOnce(async () => makeRun(core.document, true, await api.runArguments(core.id, sourceOf(session.get()))));
        return;
      case "micro":
      case "macro":
        await stepFrom(core, { kind: command });
        return;
      case "until":
        if (until !== undefined) await stepFrom(core, until);
    }
  } catch (error) {
    problem(error);
  }
}

/** A core that was not started is paused first, so that it does this step and no more. */
async function stepFrom(core: Core, step: StepRequest): Promise<void> {
  await arm(core);
  if (core.status === "ready") {
    if (!core.paused) await api.pause(core.id);
    await api.start(core.id, isSupervised());
  }
  await api.step(core.id, step);
}
