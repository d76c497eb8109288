// Services of service.test.ts, as a program: those of tests/integration/python_gripper.py.
import { operation, run, Service, ServiceFailure } from "race-client/service";
import WebSocket from "ws";

class Gripper extends Service {
  key = "grip";
  version = "1.2";
  events = { moved: "number" };
  halts = 0;

  move = operation(
    {
      moves: true,
      busy: "Moving",
      doc: "Moves the fingers.",
      parameters: { width: { type: "number", unit: "m", min: 0, max: 0.11 }, speed: { type: "number", value: 0.1 } },
    },
    async ({ width, speed }, { pause }) => {
      if (width === 0.01) throw new ServiceFailure("jammed", "the fingers are jammed", { force: 5.5 });
      for (let i = 0; i < Math.trunc(width * 1000); i++) await pause(0.05);
      this.emit("moved", width);
      return { width, speed };
    },
  );

  stop = operation({ safe: true, stops: "Moving" }, () => {
    this.halts++;
  });

  count = operation({ reads: true, result: "int" }, () => this.halts);

  lie = operation(() => this.emit("moved", "far"));

  wrong = operation({ result: "int" }, () => "far");

  fail = operation(() => {
    throw new RangeError("nothing");
  });

  nothing = operation(() => NaN);

  think = operation({ parameters: { seconds: { type: "number" } } }, async ({ seconds }, { pause }) => {
    await pause(seconds);
    return this.state;
  });
}

class Timer extends Service {
  key = "patience";
  rsm = "patience.rsm.json";

  begin = operation(async (_, { pause }) => {
    await pause(0.05);
    return "begun";
  });

  wait = operation(async ({ seconds }, { pause }) => {
    await pause(seconds);
    return seconds;
  });
}

await run([new Gripper(), new Timer()], { webSocket: WebSocket });
