// English: what a person reads or hears of STOP, of the stopped cell and of its reset, besides shared/stop/texts.ts.
export const en = {
  stop: "STOP",
  layer: "Stop of the cell",
  read: "I have read this",
  banner: {
    name: "The cell is stopped",
    reset: "Reset…",
    refused: (why: string) => `Reset: ${why}.`,
  },
  reset: {
    title: "Reset the stop?",
    failed: (why: string) => `Not reset: ${why}.`,
    keep: "Keep it stopped",
    busy: "Resetting…",
    reset: "Nobody is there: reset",
  },
};
