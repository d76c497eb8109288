// Draws when asked: once per frame at most, and with rests where a frame takes long, so that the page has time for the run.
import { restAfter } from "../../shared/cell/pace";

export class Pace {
  private asked = false;
  private busy = false;
  private frame = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly draw: () => void) {}

  ask(): void {
    this.asked = true;
    if (!this.busy) this.next();
  }

  stop(): void {
    this.busy = true;
    cancelAnimationFrame(this.frame);
    clearTimeout(this.timer);
  }

  private next(): void {
    this.asked = false;
    this.busy = true;
    this.frame = requestAnimationFrame(() => {
      const begun = performance.now();
      this.draw();
      // Without a GPU the browser waits for the picture after this callback, before any timer.
      this.timer = setTimeout(() => {
        this.timer = setTimeout(() => this.rested(), restAfter(performance.now() - begun));
      });
    });
  }

  private rested(): void {
    this.busy = false;
    if (this.asked) this.next();
  }
}
