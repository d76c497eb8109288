// The keys of the view in which an application is built; everything they do has a button, too.
import { duplicateSelected, moveSelected, removeSelected } from "./step/actions";
import { closeSheet } from "./closeSheet";
import { takeBack } from "./editing";
import { select } from "./select";

const isTyping = (target: EventTarget | null): boolean => target instanceof HTMLElement && (target.matches("input:not([type=range], [type=checkbox], [type=radio]), textarea, select") || target.isContentEditable);

const kWithControl: Readonly<Record<string, () => void>> = {
  z: () => takeBack("undo"), y: () => takeBack("redo"), Z: () => takeBack("redo"), d: duplicateSelected,
};

/** The step or task of the card that has the focus, which is what Delete and the arrows act on. */
const cardOf = (target: EventTarget | null): string | undefined => (target instanceof HTMLElement ? target.closest<HTMLElement>("[data-step]")?.dataset["step"] : undefined);

const kOnCard: Readonly<Record<string, () => void>> = { Delete: removeSelected };
const kWithAlt: Readonly<Record<string, () => void>> = { ArrowLeft: () => moveSelected(-1), ArrowUp: () => moveSelected(-1), ArrowRight: () => moveSelected(1), ArrowDown: () => moveSelected(1) };

export function handleKey(event: KeyboardEvent): void {
  if (event.defaultPrevented || document.querySelector("dialog[open]") !== null) return;
  const act = (): (() => void) | undefined => {
    if (event.key === "Escape") return closeSheet;
    if (isTyping(event.target)) return undefined;
    if ((event.ctrlKey || event.metaKey) && !event.altKey) return kWithControl[event.key];
    const card = cardOf(event.target);
    const onCard = event.altKey ? kWithAlt[event.key] : kOnCard[event.key];
    if (card === undefined || onCard === undefined) return undefined;
    return () => {
      select(card, false);
      onCard();
    };
  };
  const found = act();
  if (found === undefined) return;
  if (event.key !== "Escape") event.preventDefault();
  found();
}
