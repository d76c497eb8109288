// A gripper of your own, 1 mm in 10 ms: replace what `move` does by what your device needs.
import { operation, run, Service } from "race-client/service";
import WebSocket from "ws"; // Node 22 has one of its own

const STROKE = 0.11; // [m] between the fingers

class Gripper extends Service {
  key = "my_gripper";
  events = { moved: "number" };
  width = STROKE;

  move = operation({ moves: true, busy: "Moving", parameters: { width: { type: "number", unit: "m", min: 0, max: STROKE } } }, async ({ width }, { pause }) => {
    while (Math.abs(width - this.width) > 0.0005) {
      await pause(0.01); // ends here if `stop` was called, or the server is lost
      this.width = Math.round(1000 * this.width + (width > this.width ? 1 : -1)) / 1000;
    }
    this.emit("moved", this.width);
    return { width };
  });

  stop = operation({ safe: true, stops: "Moving", doc: "The fingers stay where they are." }, () => undefined);

  get = operation({ reads: true, result: { record: { width: "number" } } }, () => ({ width: this.width }));
}

await run(new Gripper(), { webSocket: WebSocket });
