// How much work a layout has done, so that tests can hold that it is bounded whatever the machine is.

export interface Work {
  steps: number;
}
