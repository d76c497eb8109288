// The controls as a page takes, holds, gives back and loses them.
import { describe, expect, it } from "vitest";
import { CallError, controlUrl, createControlLink, type LinkState, type SocketHandlers } from "../../shared/control/link";

const kTaken = { kind: "taken", number: 3, secret: "control_abc", beat_ms: 100, silence_ms: 250, most_calls: 6 };

function fixture() {
  let time = 1000;
  let timers: readonly { readonly time: number; readonly act: () => void; next: number }[] = [];
  const states: LinkState[] = [];
  const sent: unknown[] = [];
  const sockets: { readonly address: string; readonly handlers: SocketHandlers; closed: boolean }[] = [];
  const link = createControlLink({
    open: (address, handlers) => {
      const socket = { address, handlers, closed: false };
      sockets.push(socket);
      return { send: (text) => void sent.push(JSON.parse(text)), close: () => void (socket.closed = true) };
    },
    now: () => time,
    every: (interval, act) => {
      const timer = { time: interval, act, next: time + interval };
      timers = [...timers, timer];
      return () => (timers = timers.filter((each) => each !== timer));
    },
    onChange: (state) => void states.push(state),
  });
  const settle = async () => {
    for (let i = 0; i < 5; i++) await Promise.resolve();
  };
  const last = () => {
    const socket = sockets.at(-1);
    if (socket === undefined) throw new Error("nothing was opened");
    return socket;
  };
  const tell = (message: unknown) => last().handlers.onText(JSON.stringify(message));
  return {
    link, states, sent, sockets, settle, tell, last,
    timers: () => timers.length,
    pass(wait: number) {
      for (const end = time + wait; ; ) {
        const due = [...timers].sort((a, b) => a.next - b.next)[0];
        if (due === undefined || due.next > end) return void (time = end);
        time = Math.max(time, due.next);
        due.next = time + due.time;
        due.act();
      }
    },
    /** The page stands still: its timers are late. */
    stall: (wait: number) => void (time += wait),
    async take(force = false) {
      link.take(() => Promise.resolve("ws://cell/hold"), force);
      await settle();
      last().handlers.onOpen();
    },
    async hold() {
      link.take(() => Promise.resolve("ws://cell/hold"));
      await settle();
      last().handlers.onOpen();
      tell(kTaken);
      sent.length = 0;
    },
  };
}

describe("the controls of a page", () => {
  it("are taken by nothing but a person", async () => {
    const f = fixture();
    await f.settle();
    f.pass(10_000);
    expect([f.link.get().kind, f.sockets.length]).toEqual(["none", 0]);
  });

  it("are theirs once the server says so, and kept by a sign of life at once and each 80 ms", async () => {
    const f = fixture();
    await f.take();
    expect(f.sent).toEqual([{ type: "take" }]);
    expect(f.link.get().kind).toBe("taking");
    expect(f.link.secret()).toBeUndefined();
    f.tell(kTaken);
    expect(f.link.get()).toEqual({ kind: "held", number: 3, secret: "control_abc", since: 1000 });
    expect(f.link.secret()).toBe("control_abc");
    expect(f.sent.slice(1)).toEqual([{ type: "beat" }]);
    f.pass(800);
    expect(f.sent).toHaveLength(2 + 10);
  });

  it("are given back, and nothing goes on afterwards", async () => {
    const f = fixture();
    await f.hold();
    f.link.release();
    expect([f.sent, f.link.get(), f.last().closed, f.timers()]).toEqual([[{ type: "release" }], { kind: "none" }, true, 0]);
    f.tell(kTaken);
    expect(f.link.get().kind, "what comes late says nothing").toBe("none");
  });

  it("are lost with the page, which says why", async () => {
    const f = fixture();
    await f.hold();
    f.link.release("this page was hidden");
    expect(f.link.get()).toEqual({ kind: "lost", why: "this page was hidden" });
    f.pass(60_000);
    expect([f.link.get().kind, f.sockets.length], "nor are they taken again").toEqual(["lost", 1]);
    f.link.dismiss();
    expect(f.link.get().kind).toBe("none");
  });

  it("are lost when the server says so, or is gone, and not taken again", async () => {
    for (const lose of [(f: ReturnType<typeof fixture>) => f.tell({ kind: "lost", code: "leased", message: "you were silent" }), (f: ReturnType<typeof fixture>) => f.last().handlers.onClose()]) {
      const f = fixture();
      await f.hold();
      lose(f);
      f.pass(60_000);
      expect([f.link.get().kind, f.sockets.length, f.timers(), f.link.secret()]).toEqual(["lost", 1, 0, undefined]);
    }
  });

  it("are lost when the page itself was silent, whatever the server says of it later", async () => {
    const f = fixture();
    await f.hold();
    f.stall(400);
    f.pass(0);
    expect(f.link.get()).toEqual({ kind: "lost", why: "this page stood still for 400 ms" });
    expect([f.last().closed, f.sent]).toEqual([true, []]);
  });

  it("are lost for the same reason when the server says so first", async () => {
    const f = fixture();
    await f.hold();
    f.stall(400);
    f.tell({ kind: "lost", code: "leased", message: "you have not the controls of the cell any more" });
    expect(f.link.get()).toEqual({ kind: "lost", why: "this page stood still for 400 ms" });
  });

  it("stay theirs while a sign of life is a little late", async () => {
    const f = fixture();
    await f.hold();
    f.stall(200);
    f.pass(0);
    expect([f.link.get().kind, f.sent.length]).toEqual(["held", 1]);
  });

  it("are refused while another one has them, with the reason", async () => {
    const f = fixture();
    await f.take();
    f.tell({ kind: "refused", code: "leased", message: "bob has the controls of the cell" });
    expect([f.link.get(), f.last().closed]).toEqual([{ kind: "refused", why: "bob has the controls of the cell" }, true]);
  });

  it("are asked for, and got or not", async () => {
    for (const [answer, kind] of [[kTaken, "held"], [{ kind: "refused", code: "leased", message: "no" }, "refused"]] as const) {
      const f = fixture();
      await f.take(true);
      expect(f.sent).toEqual([{ type: "take", force: true }]);
      f.tell({ kind: "asked", request: 7 });
      expect(f.link.get()).toEqual({ kind: "asked", request: 7, since: 1000 });
      f.tell(answer);
      expect(f.link.get().kind).toBe(kind);
    }
  });

  it("are not asked for any more when the page is hidden meanwhile", async () => {
    const f = fixture();
    await f.take(true);
    f.tell({ kind: "asked", request: 7 });
    f.link.release("this page was hidden");
    expect([f.link.get().kind, f.last().closed]).toEqual(["refused", true]);
  });

  it("are not taken with an address that comes after it was given up", async () => {
    const f = fixture();
    let give: (address: string) => void = () => undefined;
    f.link.take(() => new Promise((resolve) => (give = resolve)));
    f.link.release();
    give("ws://cell/hold");
    await f.settle();
    expect([f.sockets.length, f.link.get().kind]).toEqual([0, "none"]);
    f.link.take(() => Promise.reject(new Error("the server wants a login")));
    await f.settle();
    expect(f.link.get()).toEqual({ kind: "refused", why: "the server wants a login" });
  });

  it("are lost by a message that nobody understands", async () => {
    const f = fixture();
    await f.hold();
    f.tell({ kind: "given" });
    expect(f.link.get().kind).toBe("lost");
  });
});

describe("a call by hand", () => {
  it("is answered with its result or its error", async () => {
    const f = fixture();
    await f.hold();
    const calls = [f.link.call("robot", "jog", { linear: [0, 0, 0.1] }), f.link.call("robot", "stop")];
    expect(f.sent).toEqual([
      { type: "call", number: 1, service: "robot", operation: "jog", kwargs: { linear: [0, 0, 0.1] } },
      { type: "call", number: 2, service: "robot", operation: "stop", kwargs: {} },
    ]);
    f.tell({ kind: "response", number: 2, result: null });
    f.tell({ kind: "response", number: 1, error: { code: "not_accepted", message: "nothing is moved by hand in execution mode" } });
    const [jog, stop] = await Promise.allSettled(calls);
    expect(stop).toEqual({ status: "fulfilled", value: null });
    expect(jog).toMatchObject({ status: "rejected", reason: { name: "CallError", code: "not_accepted", message: "nothing is moved by hand in execution mode" } });
  });

  it("fails without the controls, when they are lost meanwhile, and when too many wait", async () => {
    const f = fixture();
    await expect(f.link.call("robot", "stop")).rejects.toMatchObject({ code: "leased" });
    await f.hold();
    const calls = Array.from({ length: 4 }, () => f.link.call("robot", "jog").catch((error: unknown) => (error instanceof CallError ? error.code : "")));
    expect(f.sent, "the half of what the server lets wait").toHaveLength(3);
    expect(await calls.at(-1)).toBe("too_large");
    const stops = Array.from({ length: 4 }, () => f.link.call("robot", "stop").catch((error: unknown) => (error instanceof CallError ? error.code : "")));
    expect(f.sent, "what stops has more room").toHaveLength(6);
    expect(await stops.at(-1)).toBe("too_large");
    f.last().handlers.onClose();
    expect(await Promise.all(calls.slice(0, -1))).toEqual(["leased", "leased", "leased"]);
  });
});

describe("the address of the controls", () => {
  it("is that of the server of the page", () => {
    expect(controlUrl({ protocol: "https:", host: "cell:8443" })).toBe("wss://cell:8443/api/v1/control/hold");
  });
});
