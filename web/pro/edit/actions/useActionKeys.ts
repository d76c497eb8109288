// The keys of the actions. They do nothing while one types, in a form, or while the page asks something.
import { useEffect } from "react";
import { pressText } from "../../../shared/session/shortcuts";
import { isTyping } from "../../useShortcuts";
import { view } from "../../client";
import { isPageCovered } from "../../covered";
import { takeFocused } from "../gestures/focused";
import { isPrompting } from "../prompt";
import { runAction, type Action } from "./action";
import { pasteText } from "./clipboardActions";
import { actions } from "./registry";

/** Where keys are for the model: the drawing and the tree of states. */
const kModel = '#edit-canvas, [role="tree"]';

const isInModel = (target: EventTarget | null): boolean => target instanceof Element && target.closest(kModel) !== null;

function acts({ where }: Action, target: EventTarget | null): boolean {
  switch (where) {
    case "model":
      return isInModel(target) && !isTyping(target);
    case "untyped":
      return !isTyping(target);
    case "anywhere":
      return true;
    case "page":
      return false;
  }
}

/** A button takes Enter and Space itself. */
const isOfButton = ({ key, target }: KeyboardEvent): boolean => (key === "Enter" || key === " ") && target instanceof HTMLButtonElement;

function press(event: KeyboardEvent): void {
  if (view.get().page !== "edit" || isPrompting() || isPageCovered() || isOfButton(event)) return;
  const text = pressText(event);
  const action = actions.find((each) => each.keys.includes(text) && acts(each, event.target));
  if (action === undefined) return;
  event.preventDefault();
  if (event.repeat && action.repeats !== true) return;
  if (isInModel(event.target)) takeFocused();
  runAction(action);
}

/** What the browser pastes in the drawing or the tree. */
function takePasted(event: ClipboardEvent): void {
  if (view.get().page !== "edit" || isPrompting() || isTyping(event.target) || !isInModel(document.activeElement)) return;
  event.preventDefault();
  pasteText(event.clipboardData?.getData("text/plain") ?? "");
}

/** The middle button moves the drawing. Where the system has a selection to paste, it would be pasted when the button is released. */
function keepFromPasting(event: MouseEvent): void {
  if (event.button === 1 && isInModel(event.target)) event.preventDefault();
}

export function useActionKeys(): void {
  useEffect(() => {
    addEventListener("mouseup", keepFromPasting);
    addEventListener("keydown", press);
    addEventListener("paste", takePasted);
    return () => {
      removeEventListener("mouseup", keepFromPasting);
      removeEventListener("keydown", press);
      removeEventListener("paste", takePasted);
    };
  }, []);
}
