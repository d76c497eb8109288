// Which moment of the run is shown. It is in the address (`at=12.3`), so that the browser's Back and a shared link lead there.
import type { Past } from "../../generated/messages";
import { isSameMoment, momentOf, momentText, type Wanted } from "../../shared/past/moment";
import { moved, type Move } from "../../shared/past/moves";
import { addressWith, placeOfAddress } from "../../shared/session/address";
import { watchedCore } from "../../shared/session/session";
import type { WantedInference } from "../../shared/session/view";
import { api, problem, session, sourceOf, view } from "../client";
import { writePlace } from "../placeAddress";
import { createStore, useSelected } from "../../page/store";
import { modelThen } from "./pastModel";

/** How the address changes: a new entry of the browser's history, the same one, or it is there already. */
type Written = "push" | "replace" | "there";

/** So many moves wait while the server computes a moment: what a held key adds is dropped. */
const kMostWaiting = 8;
/** Derivations are loaded of so many macro steps before and after the moment. */
const kAround = 10;

let waiting: readonly (() => Promise<void>)[] = [];
let isWorking = false;
/** Counts what makes the moments that are still asked for unwanted. */
let turns = 0;

async function work(): Promise<void> {
  if (isWorking) return;
  isWorking = true;
  for (let [task] = waiting; task !== undefined; [task] = waiting) {
    waiting = waiting.slice(1);
    try {
      await task();
    } catch (error) {
      problem(error);
    }
  }
  isWorking = false;
}

/** The macro step that was asked for and is not shown yet. */
const asked = createStore<number | undefined, number | undefined>(undefined, (_, step) => step);
export const useAsked = (): number | undefined => useSelected(asked, (step) => step);

function write(at: string | undefined, how: Written): void {
  if (how === "there" || placeOfAddress(location.search).at === at) return;
  if (how === "push") writePlace();
  history[how === "push" ? "pushState" : "replaceState"](null, "", addressWith(location.search, { at }));
}

/** Shows the run as it is. */
export function toPresent(how: Written = "push"): void {
  const { watched, past } = session.get();
  waiting = [];
  turns++;
  asked.dispatch(undefined);
  write(undefined, how);
  if (past === undefined || watched === undefined) return;
  session.dispatch({ type: "moment", id: watched, shown: undefined });
  view.dispatch({ type: "turn_to_step", step: undefined });
}

/** The micro step by which the moment came. */
const doneLast = ({ micro }: Past): WantedInference | undefined => (micro === 0 ? undefined : { micro: micro - 1 });

const ask = (id: string, wanted: Wanted): Promise<Past> => api.past(sourceOf(session.get()), id, wanted);

/** `turn`: when it was asked for. `inference`: shown of its derivation. */
async function show(id: string, past: Past, how: Written, turn: number, inference: WantedInference | undefined): Promise<void> {
  const then = await modelThen(id, past.step);
  const now = session.get();
  if (now.watched !== id || turn !== turns) return;
  const steps = now.past?.steps ?? [];
  session.dispatch({ type: "moment", id, shown: { past, steps, model: then.model, doubt: then.doubt } });
  view.dispatch({ type: "turn_to_step", step: past.step, inference });
  write(momentText(past), how);
  if ([...now.steps, ...steps].every(({ step }) => step !== past.step)) void loadAround(id, past);
}

async function loadAround(id: string, past: Past): Promise<void> {
  const last = watchedCore(session.get())?.step ?? past.step;
  try {
    const steps = await api.derivations(id, Math.max(1, past.step - kAround), Math.min(last, past.step + kAround), sourceOf(session.get()));
    const { past: shown } = session.get();
    if (shown !== undefined && isSameMoment(shown.past, past)) session.dispatch({ type: "moment", id, shown: { ...shown, steps } });
  } catch (error) {
    problem(error);
  }
}

/** Shows this moment, with its derivation at the micro step before, or at `inference`; moves that wait are given up. */
export function visit(wanted: Wanted, how: Written = "push", inference?: WantedInference): void {
  const { watched } = session.get();
  if (watched === undefined) return;
  asked.dispatch(wanted.step);
  const turn = ++turns;
  const task = async () => {
    try {
      const past = await ask(watched, wanted);
      await show(watched, past, how, turn, inference ?? (wanted.micro === undefined ? undefined : doneLast(past)));
    } catch (error) {
      if (turn === turns && session.get().past === undefined) write(undefined, "replace");
      throw error;
    } finally {
      if (turn === turns) asked.dispatch(undefined);
    }
  };
  waiting = [task];
  void work();
}

/** Shows the model as it was at the end of a macro step; the last one is the present. */
export function visitStep(step: number): void {
  const core = watchedCore(session.get());
  if (core !== undefined && step >= core.step) toPresent();
  else visit({ step });
}

async function moveOnce(move: Move, how: Written): Promise<void> {
  const { watched, past } = session.get();
  const core = watchedCore(session.get());
  const turn = turns;
  if (watched === undefined || core === undefined || core.step === 0) return;
  if (past === undefined && (move === "forward" || move === "forward_step")) return;
  const from = past?.past ?? (await ask(watched, { step: core.step }));
  const target = moved(move, from, core.step);
  if (target === undefined) return;
  if (target === "present") {
    toPresent(how);
    return;
  }
  const found = await ask(watched, target);
  // Of the macro step that is not complete, there may be no more than this: it is the present.
  if (isSameMoment(found, from)) toPresent(how);
  else await show(watched, found, how, turn, target.micro === undefined ? undefined : doneLast(found));
}

/** `held`: by a key that is held, so that the browser's history does not get an entry of each. */
export function move(by: Move, held = false): void {
  if (waiting.length < kMostWaiting) waiting = [...waiting, () => moveOnce(by, held ? "replace" : "push")];
  void work();
}

/** Shows what the address says. */
function followAddress(): void {
  const { at } = placeOfAddress(location.search);
  const wanted = momentOf(at);
  const { past } = session.get();
  if (wanted === undefined) toPresent("there");
  else if (past === undefined || momentText(past.past) !== at) visit(wanted, "there");
}

/** Lets the address and the page go together; to be called once. */
export function followMoments(): void {
  let shown: unknown;
  session.listen(() => {
    const now = session.get();
    const turned = now.stored ?? now.watched;
    if (turned === shown) return;
    shown = turned;
    waiting = [];
    turns++;
    if (turned !== undefined) followAddress();
  });
  addEventListener("popstate", () => {
    const { run } = placeOfAddress(location.search);
    if (run === undefined || run === session.get().watched) followAddress();
  });
}
