// The place of the page in its address: `?edit=NAME` of the application, `task` and `step` of what is selected (ids), `#run` where the run is shown;
// `guide` of the step of the guide, with the poses `part` and `place` that were taught in it.
import { createStore, useSelected } from "../page/store";
import { openApplication } from "./editing";

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

/** Another application or view is a page of its own for the browser's Back; another selection is not. */
export function go(change: Partial<Place>): void {
  const before = store.get();
  const next = { ...before, ...change };
  if (addressOf(next) === addressOf(before)) return;
  const isPage = next.edit !== before.edit || next.view !== before.view || next.guide !== before.guide;
  history[isPage ? "pushState" : "replaceState"](null, "", addressOf(next));
  store.dispatch(next);
  if (next.edit !== before.edit) openApplication(next.edit);
}

/** Opens what the address says, now and when the browser goes back. */
export function followAddress(): void {
  const follow = () => {
    const before = store.get();
    store.dispatch(read());
    if (store.get().edit !== before.edit) openApplication(store.get().edit);
  };
  addEventListener("popstate", follow);
  addEventListener("hashchange", follow);
  openApplication(store.get().edit);
}
