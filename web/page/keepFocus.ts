// Keeps the focus of the keyboard where one was: what has it may go away, as a question that is answered, or may not be pressed any more, as Start.
// Then the part of the page around it has the focus, from which Tab goes on; it comes back with the element.

const kParts = 'dialog, [role="toolbar"], [role="tree"], section, aside, main, footer, header, .app, .one, .display, #root';

interface Held {
  readonly element: HTMLElement;
  readonly around: readonly Element[];
}
/** What had the focus last; nothing after a click beside it. */
let held: Held | undefined;
/** The last element outside of any dialog. */
let outside: Held | undefined;
/** What has the focus in place of `held`. */
let stand: Element | undefined;
/** While a key is down, what got the focus would be pressed by it, too. */
let isKeyDown = false;

const isGone = (element: HTMLElement): boolean => !element.isConnected || element.matches(":disabled");

function around(element: Element): readonly Element[] {
  const parent = element.parentElement;
  return parent === null ? [] : [parent, ...around(parent)];
}

/** Gives the focus to what is no stop of Tab, now or later. */
export function focusPart(part: HTMLElement): void {
  stand = part;
  if (!part.hasAttribute("tabindex")) {
    part.tabIndex = -1;
    part.addEventListener("blur", () => part.removeAttribute("tabindex"), { once: true });
  }
  part.focus({ preventScroll: true });
}

function give({ element, around: parts }: Held): void {
  const dialogs = [element, ...parts].filter((part) => part.matches("dialog"));
  const isDialogGone = dialogs.length > 0 && !dialogs.some((dialog) => dialog.isConnected);
  if (isDialogGone && outside !== undefined && outside.element !== element) {
    if (isGone(outside.element)) give(outside);
    else outside.element.focus({ preventScroll: true });
    return;
  }
  const part = parts.find((each) => each.isConnected && each.matches(kParts));
  if (part instanceof HTMLElement) focusPart(part);
}

function look(): void {
  if (held === undefined || isKeyDown) return;
  const at = document.activeElement;
  const isLost = at === null || at === document.body || at === held.element;
  if (isLost && isGone(held.element)) give(held);
  else if (at !== null && at === stand && !isGone(held.element)) held.element.focus({ preventScroll: true });
}

function take({ target }: FocusEvent): void {
  if (!(target instanceof HTMLElement) || target === stand) return;
  stand = undefined;
  held = { element: target, around: around(target) };
  if (target.closest("dialog") === null) outside = held;
}

/** A click beside what had the focus ends that; in a dialog, the dialog remains, which gives the focus back when it is closed. */
function point({ target }: PointerEvent): void {
  const dialog = target instanceof Element ? target.closest<HTMLElement>("dialog") : null;
  held = dialog === null ? undefined : { element: dialog, around: around(dialog) };
}

function release(): void {
  isKeyDown = false;
  setTimeout(look);
}

/** To be called once. */
export function keepFocus(): void {
  addEventListener("keydown", () => (isKeyDown = true), { capture: true });
  addEventListener("keyup", release, { capture: true });
  addEventListener("blur", release);
  document.addEventListener("focusin", take);
  document.addEventListener("pointerdown", point, { capture: true });
  new MutationObserver(look).observe(document.body, { childList: true, subtree: true, attributes: true, attributeFilter: ["disabled"] });
}
