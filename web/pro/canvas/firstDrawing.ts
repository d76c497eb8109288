// What can wait for the first drawing of the page: loading it earlier would only delay what people look at first.

/** After this time [ms] nothing waits any more: there may be nothing to draw. */
const kLongest = 1500;

let tell: () => void = () => undefined;
const drawn = new Promise<void>((resolve) => {
  tell = resolve;
});

/** A drawing is complete: in the next frame it is on the screen. */
export function noteDrawing(): void {
  requestAnimationFrame(() => requestAnimationFrame(tell));
}

export const afterFirstDrawing = (): Promise<void> => Promise.race([drawn, new Promise<void>((resolve) => setTimeout(resolve, kLongest))]);
