// How much work a layout has done, so that tests can hold that it is bounded whatever the machine is.

export interface Work {
  /** Ways and places that were tried. */
  steps: number;
  /** Boxes that were looked at for them, and cells of an index. */
  looks: number;
}

export const noWork = (): Work => ({ steps: 0, looks: 0 });
