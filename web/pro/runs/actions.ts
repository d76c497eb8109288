// What is done with stored runs, and the place of their list in the address.
import { addressWith, placeOfAddress } from "../../shared/session/address";
import type { Moment } from "../../shared/past/moment";
import { messageOf } from "../../shared/messageOf";
import { testFileOf } from "../../shared/runs/testFile";
import { watchedCore } from "../../shared/session/session";
import { api, problem, session, turnToRun, view } from "../client";
import { visit } from "../past/past";
import { saveText } from "../saveText";

export function showRuns(shown: boolean): void {
  view.dispatch({ type: "runs", shown });
}

/** Shows a run as it is, or as it was at its end; the browser's Back leads to what was shown before. */
export async function openRun(id: string): Promise<void> {
  showRuns(false);
  view.dispatch({ type: "page", page: "task" });
  history.pushState(null, "", location.search);
  await turnToRun(id);
}

/** Shows a run as it was at a moment, with the derivation of the micro step that follows; at the end of one that has no such macro step. */
export async function openRunAt(id: string, moment: Moment): Promise<void> {
  await openRun(id);
  const last = watchedCore(session.get())?.step ?? 0;
  const inference = { micro: moment.micro };
  view.dispatch({ type: "step", step: Math.min(moment.step, last), inference });
  if (moment.step <= last) visit(moment, "push", inference);
}

/** Saves a test of a run as a file. Throws why none can be made. */
export async function saveTest(id: string, document: string): Promise<void> {
  const text = await api.runTest(id).catch((error: unknown) => {
    throw new Error(`No test is made: ${messageOf(error)}`);
  });
  saveText(testFileOf(document), "application/json", text);
}

/** Stores the file of a run, and shows it. Throws what the server refuses. */
export async function openRunFile(text: string): Promise<void> {
  const { id } = await api.importRun(text);
  await openRun(id);
}

/** Lets the address and the list go together, and the run with the browser's Back; to be called once. */
export function followRuns(): void {
  const read = () => showRuns(placeOfAddress(location.search).runs !== undefined);
  read();
  view.listen(() => {
    const runs = view.get().runs ? "1" : undefined;
    if (placeOfAddress(location.search).runs !== runs) history.replaceState(null, "", addressWith(location.search, { runs }));
  });
  addEventListener("popstate", () => {
    read();
    const { run } = placeOfAddress(location.search);
    if (run !== undefined && run !== session.get().watched) turnToRun(run).catch(problem);
  });
}
