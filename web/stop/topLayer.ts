// Keeps an element over all others, and usable: in the topmost modal dialog, if there is one, as that takes the input of all that is outside of it.

/** Modal dialogs in the order in which they were opened; `before`: as they were. */
function opened(dialogs: Iterable<HTMLDialogElement>, before: readonly HTMLDialogElement[]): readonly HTMLDialogElement[] {
  const modal = [...dialogs].filter((dialog) => dialog.matches(":modal"));
  return [...before.filter((dialog) => modal.includes(dialog)), ...modal.filter((dialog) => !before.includes(dialog))];
}

/** `layer` is a manual popover. `data-dialog` tells whether it is in a dialog. To be called once. */
export function keepOnTop(layer: HTMLElement): void {
  const dialogs = document.getElementsByTagName("dialog");
  let order: readonly HTMLDialogElement[] = [];
  const look = () => {
    order = opened(dialogs, order);
    const top = order.at(-1) ?? document.body;
    if (layer.parentElement === top && layer.isConnected) return;
    layer.toggleAttribute("data-dialog", top !== document.body);
    top.append(layer);
    // What is shown last is above: the dialog is there already.
    layer.showPopover();
  };
  look();
  new MutationObserver(look).observe(document, { subtree: true, childList: true, attributes: true, attributeFilter: ["open"] });
}
