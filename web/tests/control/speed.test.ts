// How fast the robot goes on its way: when that is asked for, and what is said of it.
import { describe, expect, it } from "vitest";
import type { HostedService } from "../../generated/messages";
import { createSpeedWatch, kPause, speedSign, type SpeedState } from "../../shared/control/speed";
import type { StreamUpdate } from "../../shared/messages/stream";

const robot = {
  key: "arm", available: true, type: "Robot", state: "Idle", pending_count: 0, pending: [], violations: [], publishes: [], subscribes: [],
  rsm: {
    operations: [{ name: "speed_override" }, { name: "state" }],
    transitions: [{ id: "override", src: "Idle", dst: "Idle", operation: "speed_override" }, { id: "state", src: "Idle", dst: "Idle", operation: "state" }],
  },
} as unknown as HostedService;
const changed = (last: string): StreamUpdate => ({ type: "services_changed", services: [{ ...robot, last }] });
const whole: StreamUpdate = { type: "services", services: [robot] };

function fixture(answers: readonly (number | Error)[], refusal?: string) {
  const states: SpeedState[] = [];
  const waiting: { readonly time: number; readonly act: () => void }[] = [];
  let asked = 0;
  const watch = createSpeedWatch({
    ask: () => {
      const answer = answers[asked++] ?? new Error("asked too often");
      return answer instanceof Error ? Promise.reject(answer) : Promise.resolve({ speed_override: answer });
    },
    services: () => [robot],
    refusal: () => refusal,
    after: (time, act) => waiting.push({ time, act }),
    onChange: (state) => states.push(state),
  });
  const settle = () => new Promise((resolve) => setTimeout(resolve));
  const rest = async () => {
    await settle();
    waiting.splice(0).forEach(({ time, act }) => {
      expect(time).toBe(kPause);
      act();
    });
    await settle();
  };
  return { watch, states, rest, settle, asked: () => asked, share: () => states.at(-1)?.share };
}

describe("the speed of the robot", () => {
  it("is asked for when the services are there, and again when it is set", async () => {
    const { watch, rest, asked, share } = fixture([1, 0.2]);
    watch.receive(whole);
    await rest();
    expect([asked(), share()]).toEqual([1, 1]);
    watch.receive(changed("override"));
    await rest();
    expect([asked(), share()]).toEqual([2, 0.2]);
  });

  it("is not asked for because it was asked for: that is a transition of the robot, too", async () => {
    const { watch, rest, asked } = fixture([1]);
    watch.receive(whole);
    await rest();
    for (let i = 0; i < 5; i++) watch.receive(changed("state"));
    await rest();
    expect(asked()).toBe(1);
  });

  it("is asked for once for all that comes meanwhile, after a pause", async () => {
    const { watch, rest, settle, asked, share } = fixture([0.4, 0.5]);
    watch.receive(whole);
    await settle();
    for (let i = 0; i < 20; i++) watch.receive(changed("override"));
    await settle();
    expect(asked()).toBe(1);
    await rest();
    expect([asked(), share()]).toEqual([2, 0.5]);
    await rest();
    expect(asked()).toBe(2);
  });

  it("is asked for when the cell is stopped or reset, and when a run begins, but not with each of its steps", async () => {
    const { watch, rest, asked } = fixture([1, 1, 1, 1]);
    watch.receive(whole);
    await rest();
    const control = (stopped: boolean) => ({ type: "control", control: { mode: "execution", stopped: stopped ? { by: "ada" } : null } }) as unknown as StreamUpdate;
    const core = (status: string, step: number) => ({ type: "core", core: { id: "1", status, step } }) as unknown as StreamUpdate;
    const counts: number[] = [];
    for (const update of [control(true), control(true), control(false), core("running", 1), core("running", 2), core("running", 3)]) {
      watch.receive(update);
      await rest();
      counts.push(asked());
    }
    expect(counts).toEqual([2, 2, 3, 4, 4, 4]);
  });

  it("stays as it was when it is not answered, and is unknown when the server is gone", async () => {
    const { watch, rest, share } = fixture([0.3, new Error("no answer")]);
    watch.receive(whole);
    await rest();
    watch.receive(changed("override"));
    await rest();
    expect(share()).toBe(0.3);
    watch.forget();
    expect(share()).toBeUndefined();
  });

  it("is not asked for by who may not", async () => {
    const { watch, rest, asked } = fixture([1], "you may not");
    watch.receive(whole);
    await rest();
    expect(asked()).toBe(0);
  });

  it("is said when it is not the whole, and unmistakably when it is nothing", () => {
    expect([undefined, 1, 0.2, 0.999, 0.001].map((share) => speedSign(share)?.title)).toEqual([undefined, undefined, "Speed: 20 %", "Speed: 99 %", "Speed: 1 %"]);
    expect(speedSign(0)).toMatchObject({ title: "Speed: 0 %", stands: true });
    expect(speedSign(0.001)?.stands).toBe(false);
  });
});
