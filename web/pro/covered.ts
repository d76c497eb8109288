// What is over the page: its keys then act on nothing below.

/** Whether a modal dialog is open, whichever: also while the focus is nowhere in it, as after a click on its text. */
export const isPageCovered = (): boolean => document.querySelector("dialog:modal") !== null;
