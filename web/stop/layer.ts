// The button, and what a person must read at once: that a stop has no answer, or failed; in a dialog also that the cell is stopped.
import { kStopKey } from "../shared/stop/key";
import { viewOf, type StopState } from "../shared/stop/state";
import { kStopHint, kStoppedMeans, stoppedText, warningText } from "../shared/stop/texts";
import { texts } from "./texts";

export interface StopLayer {
  readonly element: HTMLElement;
  readonly draw: (state: StopState) => void;
}

/** What a press does besides would be meant for the page below. */
const kKept = ["pointerdown", "mousedown", "click", "dblclick", "keydown", "keyup", "contextmenu"] as const;

/** A click so soon after a touch belongs to it [ms]. */
const kTouch = 1000;

function make<Name extends keyof HTMLElementTagNameMap>(name: Name, attributes: Readonly<Record<string, string>>, ...inside: readonly (Node | string)[]): HTMLElementTagNameMap[Name] {
  const made = document.createElement(name);
  for (const [attribute, value] of Object.entries(attributes)) made.setAttribute(attribute, value);
  made.append(...inside);
  return made;
}

/** Acts as it goes down: a finger in a hurry slips. A key, or what presses it for a person, sends a click alone. */
function whenPressed(button: HTMLElement, press: () => void): void {
  let touched = -kTouch;
  button.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    touched = event.timeStamp;
    press();
  });
  // The focus stays where one types.
  button.addEventListener("mousedown", (event) => event.preventDefault());
  button.addEventListener("click", ({ timeStamp }) => timeStamp - touched > kTouch && press());
}

export function makeLayer(press: () => void, dismiss: () => void): StopLayer {
  const button = make("button", { type: "button", class: "stop-button", title: kStopHint, "aria-keyshortcuts": kStopKey }, texts.stop);
  whenPressed(button, press);
  const title = make("strong", {});
  const act = make("span", {});
  const read = make("button", { type: "button", class: "stop-read" }, texts.read);
  read.addEventListener("click", dismiss);
  const warning = make("div", { class: "stop-warning", role: "alert" }, title, act, read);
  const who = make("strong", {});
  const means = make("span", {}, kStoppedMeans);
  const told = make("p", { class: "stop-told", role: "status" }, who, means);
  const element = make("div", { id: "stop-layer", popover: "manual", role: "region", "aria-label": texts.layer }, button);
  for (const kind of kKept) element.addEventListener(kind, (event) => event.stopPropagation());
  const place = (part: HTMLElement, shown: boolean) => {
    if (!shown) part.remove();
    else if (!part.isConnected) button.before(part);
  };
  const draw = (state: StopState) => {
    const view = viewOf(state);
    const text = warningText(view);
    element.dataset["view"] = view;
    // What says nothing is no part of the page; the button stays where it is, and keeps the focus.
    place(warning, text !== undefined);
    read.hidden = view !== "failed";
    title.textContent = text?.title ?? "";
    act.textContent = text?.act ?? "";
    place(told, Boolean(state.stopped));
    who.textContent = state.stopped ? stoppedText(state.stopped, Date.now()) : "";
  };
  return { element, draw };
}
