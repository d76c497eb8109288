// The place of the page in its address: `?edit=NAME` of the application, `task` and `step` of what is selected (ids), `#run` where the run is shown;
// `guide` of the step of the guide, with the poses `part` and `place` that were taught in it.
import { createStore, useSelected } from "../page/store";
import { openApplication } from "./editing";
import { mayLeave } from "./leaving";

/** The steps of the guide, in their order. */
export const kGuideSteps = ["cell", "camera", "part", "place", "application", "run"] as const;
export type GuideStep = (typeof kGuideSteps)[number];

export interface Place {
  readonly edit: string | undefined;
  readonly task: string | undefined;
  readonly step: string | undefined;
  readonly view: "build" | "run";
  readonly guide: GuideStep | undefined;
  /** The pose at the part. */
  readonly part: string | undefined;
  /** The pose where it goes. */
  readonly goal: string | undefined;
}

const guideIn = (text: string | undefined): GuideStep | undefined => kGuideSteps.find((step) => step === text);

function read(): Place {
  const query = new URLSearchParams(location.search);
  const entry = (key: string) => query.get(key) ?? undefined;
  return { edit: entry("edit"), task: entry("task"), step: entry("step"), view: location.hash === "#run" ? "run" : "build", guide: guideIn(entry("guide")), part: entry("part"), goal: entry("place") };
}

function addressOf({ edit, task, step, view, guide, part, goal }: Place): string {
  const query = new URLSearchParams();
  for (const [key, value] of Object.entries({ guide, part, place: goal, edit, task, step })) if (value !== undefined) query.set(key, value);
  const text = query.toString();
  return `${text === "" ? location.pathname : `?${text}`}${view === "run" ? "#run" : ""}`;
}

const store = createStore<Place, Place>(read(), (_, next) => next);
export const usePlace = <T>(select: (place: Place) => T): T => useSelected(store, select);
export const place = (): Place => store.get();

/** Whether a run is shown, also in the guide: its view sets the speed of the robot, whatever it is. */
export const useIsRun = (): boolean => usePlace(({ edit, view, guide }) => edit !== undefined && (guide === undefined ? view === "run" : guide === "run"));

/** Of the entry of the browser's history that is shown: one more with each new entry. */
let number = 0;
/** Of an entry; nothing: a person has written it into the address, behind all others. */
function numberOf(state: unknown): number | undefined {
  return typeof state === "object" && state !== null && "number" in state && typeof state.number === "number" ? state.number : undefined;
}

/** Another application or view is a page of its own for the browser's Back; another selection is not. Edits that would be lost keep the application open until a person says otherwise. */
export function go(change: Partial<Place>): void {
  const before = store.get();
  const next = { ...before, ...change };
  if (addressOf(next) === addressOf(before)) return;
  const turn = () => turnTo(next);
  if (next.edit === before.edit || mayLeave(turn)) turn();
}

function turnTo(next: Place): void {
  const before = store.get();
  const isPage = next.edit !== before.edit || next.view !== before.view || next.guide !== before.guide;
  if (isPage) number++;
  history[isPage ? "pushState" : "replaceState"]({ number }, "", addressOf(next));
  store.dispatch(next);
  if (next.edit !== before.edit) openApplication(next.edit);
}

/** Opens what the address says, now and when the browser goes back. */
export function followAddress(): void {
  /** Edits were given up. */
  let leavesAnyway = false;
  const follow = () => {
    const [before, next] = [store.get(), read()];
    const by = (numberOf(history.state) ?? number + 1) - number;
    const leave = () => {
      leavesAnyway = true;
      history.go(by);
    };
    if (next.edit !== before.edit && by !== 0 && !leavesAnyway && !mayLeave(leave)) {
      history.go(-by);
      return;
    }
    leavesAnyway = false;
    number += by;
    history.replaceState({ number }, "");
    store.dispatch(next);
    if (next.edit !== before.edit) openApplication(next.edit);
  };
  number = numberOf(history.state) ?? 0;
  history.replaceState({ number }, "");
  addEventListener("popstate", follow);
  addEventListener("hashchange", follow);
  openApplication(store.get().edit);
}
