// What the page does for a person without being asked: sounds after a first touch, keys of a keyboard, an alarm for what is lost, a screen that stays on.
import { keyOf } from "../shared/display/numberText";
import { controls, listenToControls } from "../control/page";
import { display, key, session, soundAllowed } from "./client";
import { ownPlace } from "./place";
import { alarm, buzz, unlockSound } from "./signals";

/** Longer than the delay between the end of a touch and its click event [ms]. */
const kTap = 400;

/** Browsers play no sound before the first touch. The hint is removed after the tap, so that nothing moves under the finger. */
function unlockBySome(): void {
  const unlock = () => void unlockSound().then(() => setTimeout(soundAllowed, kTap));
  for (const touch of ["pointerup", "keydown"]) document.addEventListener(touch, unlock, { once: true });
}

function typeNumbers(): void {
  document.addEventListener("keydown", (event) => {
    const which = keyOf(event.key);
    const { content } = display.get();
    const isHidden = ownPlace().view !== "show";
    if (!isHidden && which !== undefined && content?.question !== undefined && "number" in content.question) key(which);
  });
}

/** Once for each loss: of the server, and of the controls. */
function alarmWhenLost(): void {
  let [had, held] = [false, false];
  session.listen(() => {
    const { connection } = session.get();
    if (had && connection === "lost") alarm(display.get().sound);
    if (connection !== "connecting") had = connection === "open";
  });
  listenToControls(() => {
    const { kind } = controls.get();
    if (held && kind === "lost") alarm(display.get().sound);
    held = kind === "held";
  });
}

function buzzForQuestions(): void {
  let asked: number | undefined;
  display.listen(() => {
    const question = display.get().content?.question?.id;
    if (question !== undefined && question !== asked) buzz("question");
    asked = question;
  });
}

/** The screen stays on while the page is seen; a browser that cannot, or does not want to, does not. */
function keepScreenOn(): void {
  if (!("wakeLock" in navigator)) return;
  const ask = () => {
    if (!document.hidden) navigator.wakeLock.request("screen").catch(() => undefined);
  };
  document.addEventListener("visibilitychange", ask);
  document.addEventListener("pointerup", ask, { once: true });
}

/** Once it was connected, the page opens without the server, too, and says so (sw.ts); where a browser does not want that, it does not. */
function keepShell(): void {
  if (!("serviceWorker" in navigator)) return;
  const end = session.listen(() => {
    if (session.get().connection !== "open") return;
    end();
    navigator.serviceWorker.register("/display/sw.js").catch(() => undefined);
  });
}

/** To be called once. */
export function followPerson(): void {
  unlockBySome();
  typeNumbers();
  alarmWhenLost();
  buzzForQuestions();
  keepScreenOn();
  keepShell();
}
