// What makes a run and moves it on.
import type { Core } from "../../generated/messages";
import { runParameters, type ExactDocument } from "../../shared/arguments/parameters";
import { readExact } from "../../shared/edit/exact";
import type { ExactArguments } from "../../shared/api";
import { watchedCore } from "../../shared/session/session";
import { controls } from "../../control/page";
import { isSamePress, makeOnce } from "../../page/starting";
import { api, attempt, session, watch } from "../client";
import { texts } from "../texts";
import { isSupervised } from "../../control/supervised";

/** Somebody who is not at the controls supervises nothing. */
const supervised = (): boolean => isSupervised() && controls.get().kind === "held";

async function make(document: string, args: ExactArguments): Promise<Core> {
  const core = await api.createCore(document, args);
  session.dispatch({ type: "update", update: { type: "core", core } });
  watch(core.id);
  return api.start(core.id, supervised());
}

/** Carries a command out on the run that is shown; of a double tap on what starts it, the first tap counts. */
export function run(command: "start" | "resume" | "again" | "pause" | "stop"): void {
  const core = watchedCore(session.get());
  if (core === undefined || (command === "pause" && isSamePress())) return;
  const act = () =>
    attempt(async () => {
      if (command === "again") await make(core.document, await api.runArguments(core.id, "cores"));
      else if (command === "start" || command === "resume") await api[command](core.id, supervised());
      else await api[command](core.id);
    });
  void (command === "pause" || command === "stop" ? act() : makeOnce(act));
}

/** Makes a run of a document and starts it, if it needs no arguments: those are entered on the expert page. */
export function startDocument(document: string): void {
  const begin = async () => {
    const entry = readExact(await api.documentText(document)) as unknown as { readonly document: ExactDocument };
    const missing = runParameters(entry.document).filter(({ initial }) => initial === undefined);
    if (missing.length > 0) throw new Error(texts.start.needs(document, missing.map(({ name }) => name).join(", ")));
    await make(document, {});
  };
  void makeOnce(() => attempt(begin));
}
