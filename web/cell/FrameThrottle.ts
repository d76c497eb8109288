// Draws on request, at most once per frame, and pauses after slow frames, so that the page has time for the run.
import { pauseAfter } from "../shared/cell/redraw";

export class FrameThrottle {
  private requested = false;
  private busy = false;
  private frame = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly draw: () => void) {}

  request(): void {
    this.requested = true;
    if (!this.busy) this.next();
  }

  stop(): void {
    this.busy = true;
    cancelAnimationFrame(this.frame);
    clearTimeout(this.timer);
  }

  private next(): void {
    this.requested = false;
    this.busy = true;
    this.frame = requestAnimationFrame(() => {
      const begun = performance.now();
      this.draw();
      // Without a GPU the browser renders after this callback and before any timer, so the timer measures that too.
      this.timer = setTimeout(() => {
        this.timer = setTimeout(() => this.endPause(), pauseAfter(performance.now() - begun));
      });
    });
  }

  private endPause(): void {
    this.busy = false;
    if (this.requested) this.next();
  }
}
