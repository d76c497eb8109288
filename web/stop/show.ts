// Shows STOP on a page: to be called once, before anything else of the page.
import { isStopPress } from "../shared/stop/key";
import { liftOf } from "../shared/stop/lift";
import { makeLayer } from "./layer";
import { stop } from "./page";
import { keepOnTop } from "./topLayer";

/** Above a keyboard on the screen. */
function followKeyboard(layer: HTMLElement): void {
  const seen = window.visualViewport;
  if (seen === null) return;
  const lift = () => layer.style.setProperty("--stop-lift", `${liftOf(innerHeight, seen)}px`);
  lift();
  for (const change of ["resize", "scroll"] as const) seen.addEventListener(change, lift);
}

export function showStop(): void {
  const { element, draw } = makeLayer(stop.press, stop.dismiss);
  draw(stop.get());
  stop.listen(() => draw(stop.get()));
  keepOnTop(element);
  followKeyboard(element);
  // Before the page gets it: a field, a dialog or a menu may keep a key to itself.
  addEventListener(
    "keydown",
    (event) => {
      if (!isStopPress(event)) return;
      event.preventDefault();
      event.stopPropagation();
      stop.press();
    },
    { capture: true },
  );
  stop.begin();
}
