import { describe, expect, it } from "vitest";
import type { Run, RunPicture, Samples, Timing, TraceStep } from "../../generated/messages";
import { exportRun, kMostSteps, type CellRobot, type Source } from "../../shared/mcap/exportRun";
import { inOrder } from "../../shared/mcap/inOrder";
import type { McapMessage } from "../../shared/mcap/message";
import { writeMcap } from "../../shared/mcap/writeMcap";
import { onTopic, readMcap, type ReadFile } from "./readBack";

const kCreated = 1_700_000_000_000;
const made = kCreated * 1000;
const kSteps = 250;
const kPicture = "/9j/4AA=";

const run: Run = { id: "7", document: "pick", revision: 3, arguments: { n: 1 }, status: "ended", outcome: "success", steps: kSteps, chain: "0".repeat(64), created: kCreated, ended: kCreated + 26_000, imported: false, bytes: 1 };

/** Macro step `step` begins after `step` tenths of a second; each calls once, and hears the answer in the next one, the tenth as an error. */
function traceStep(step: number): TraceStep {
  const answer = { kind: "response", service: "timer", operation: "start", call: step - 1 } as const;
  return {
    step,
    input: step === 1 ? { kind: "start" } : step === 10 ? { ...answer, error: "late" } : { ...answer, result: null },
    micro: [{ rule: "PTrigger", equation: "3.27", at: "Root", premises: [{ rule: "ACall", equation: "3.1", at: "Root", premises: [], service: "timer", operation: "start" }] }],
    calls: [{ service: "timer", operation: "start", args: [step], kwargs: { why: "x" }, call: step }],
    state: { active: ["Root"], ports: [], activated: {}, parameters: {}, results: { Root: { n: step } }, variables: {} },
  };
}
const stepsBetween = (from: number, to: number): readonly number[] => Array.from({ length: to - from + 1 }, (_, i) => from + i);

const samples: Samples = stepsBetween(1, 100).map((i) => ({ step: 2 * i, pose: { time: 50 + 0.2 * i, joints: { a1: i / 100 }, bodies: { cube: { position: [0, 0, i], orientation: [0, 0, 0, 1] } } } }));
const pictures: readonly RunPicture[] = [1, 2, 3].map((i) => ({ service: "camera", step: 20 * i, time: 50 + 2 * i, jpeg: kPicture }));
const robot: CellRobot = {
  file: "arm.urdf", text: "<robot/>",
  robot: { base: { position: [0, 0, 1], orientation: [0, 0, 0, 1] }, root: "base", joints: [{ name: "a1", kind: "turns", parent: "base", child: "link", origin: { position: [0, 0, 0], orientation: [0, 0, 0, 1] }, axis: [0, 0, 1] }] },
};

/** What a server says of such a run, and what it was asked for. */
function sourceOf(of: Run): { readonly api: Source; readonly asked: string[] } {
  const asked: string[] = [];
  const timing = (from: number, to: number): Timing => ({ steps: stepsBetween(from, to).map((step) => ({ step, time: step * 100_000, ...(step > 1 && { arrived: step * 100_000 - 500 }) })), services: [{ service: "timer", time: 0, state: "Idle" }], until: 0 });
  const api: Source = {
    storedRun: () => Promise.resolve(of),
    timing: (_, from, to) => Promise.resolve(timing(from, to)),
    derivations: (_, from, to) => {
      asked.push(`${from}-${to}`);
      return Promise.resolve(stepsBetween(from, to).map(traceStep));
    },
    samples: () => Promise.resolve(samples),
    pictures: () => Promise.resolve(pictures.map(({ service, step, time }, i) => ({ number: 4 * i, service, step, time }))),
    picture: (_, number) => Promise.resolve(pictures[number / 4] ?? (() => { throw new Error("there is no such picture"); })()),
  };
  return { api, asked };
}

const going = { signal: new AbortController().signal, told: () => undefined, loadRobots: () => Promise.resolve([robot]) };
const read = async (file: Blob): Promise<ReadFile> => readMcap(new Uint8Array(await file.arrayBuffer()));

describe("an exported run", () => {
  it("has each thing once, with the times of the run, and is read back with its checksums and schemas", async () => {
    const { api, asked } = sourceOf(run);
    const parts: number[] = [];
    const { file, notes } = await exportRun(api, "7", { ...going, told: (part) => parts.push(part) });
    const found = await read(file);
    const counts = Object.fromEntries([...new Set(found.messages.map(({ topic }) => topic))].sort().map((topic) => [topic, onTopic(found, topic).length]));
    expect(counts).toEqual({ "/images/camera": 3, "/joint_states": 100, "/log": 2 * kSteps + 1, "/race/calls": kSteps, "/race/derivations": kSteps, "/race/inputs": kSteps, "/race/services": 1, "/race/state": kSteps, "/tf": 100 });
    expect(asked).toEqual(["1-100", "101-200", "201-250"]);
    expect(notes).toEqual([]);
    const times = found.messages.map(({ time }) => time);
    expect([times[0], times.at(-1)]).toEqual([made, made + 26_000_000]);
    expect(times).toEqual([...times].sort((a, b) => a - b));
    expect([parts.length, parts.at(-1), parts.every((part, i) => part > (parts[i - 1] ?? 0))]).toEqual([kSteps + 3, 1, true]);
    expect(found.metadata).toMatchObject({ run: "7", document: "pick", revision: "3", status: "ended", outcome: "success", steps: "250", steps_without_time: "0", missing: "" });
    expect(Object.fromEntries(found.attachments)).toEqual({ "arm.urdf": "<robot/>" });
  });

  it("says what happened in a macro step, at the time at which it began", async () => {
    const found = await read((await exportRun(sourceOf(run).api, "7", going)).file);
    const tenth = (topic: string) => onTopic(found, topic)[9];
    const time = made + 1_000_000;
    expect(tenth("/race/inputs")).toMatchObject({ time, published: time - 500, sequence: 9, value: { step: 10, kind: "response", service: "timer", name: "start", call: 9, failed: true, data: '"late"' } });
    expect(tenth("/race/calls")).toMatchObject({ time, value: { step: 10, micro: 1, call: 10, service: "timer", operation: "start", args: "[10]", kwargs: '{"why":"x"}', timestamp: { sec: kCreated / 1000 + 1, nsec: 0 } } });
    expect(tenth("/race/state")?.value).toMatchObject({ step: 10, timed: true, active: ["Root"], numbers: [{ name: "Root.res.n", value: 10 }] });
    expect(JSON.parse(String((tenth("/race/derivations")?.value["micro"] as readonly { readonly tree: string }[])[0]?.tree))).toEqual(traceStep(10).micro[0]);
    const lines = onTopic(found, "/log").map(({ value }) => value);
    expect(lines.find(({ level }) => level === 3)?.["message"]).toBe("response timer.start ✕ 'late'");
    expect(lines.at(-1)).toMatchObject({ level: 2, name: "run", message: "Ended: success" });
  });

  it("has the frames and joints that were recorded, in their macro steps", async () => {
    const found = await read((await exportRun(sourceOf(run).api, "7", going)).file);
    const joints = onTopic(found, "/joint_states");
    expect(joints.at(-1)?.value["joints"]).toEqual([{ name: "a1", position: 1 }]);
    const frames = onTopic(found, "/tf")[0]?.value["transforms"] as readonly { readonly parent_frame_id: string; readonly child_frame_id: string }[];
    expect(frames.map(({ parent_frame_id, child_frame_id }) => `${parent_frame_id}>${child_frame_id}`)).toEqual(["world>base", "base>link", "world>body/cube"]);
    // Each was recorded in the tenth of a second after an even macro step began, with 0.2 s between them.
    for (const [i, { time }] of joints.entries()) expect(Math.abs(time - made - 200_000 * (i + 1) - 50_000)).toBeLessThanOrEqual(50_000);
    expect(onTopic(found, "/images/camera").map(({ value }) => value["data"])).toEqual([kPicture, kPicture, kPicture]);
  });

  it("says what is missing", async () => {
    const { api } = sourceOf(run);
    const away = await exportRun(api, "7", { ...going, loadRobots: () => Promise.reject(new Error("no world")) });
    expect(away.notes).toEqual(["There are no frames of links: no world"]);
    expect(onTopic(await read(away.file), "/tf")[0]?.value["transforms"]).toHaveLength(1);
    const other = await exportRun({ ...api, samples: () => Promise.resolve([{ step: 1, pose: { time: 1, joints: { b1: 0 }, bodies: {} } }]) }, "7", going);
    expect(other.notes).toEqual(["The cell has another robot now: there are no frames of links."]);
    const bare = await exportRun({ ...api, samples: () => Promise.resolve([]), pictures: () => Promise.resolve([]), timing: () => Promise.resolve({ steps: [], services: [], until: 0 }) }, "7", going);
    expect(bare.notes).toHaveLength(3);
    const found = await read(bare.file);
    expect(found.metadata["missing"]).toBe(bare.notes.join(" "));
    expect(onTopic(found, "/race/state").map(({ time, value }) => [time, value["timed"]])).toEqual(stepsBetween(1, kSteps).map(() => [made, false]));
  });

  it("is given up between two requests", async () => {
    const ending = new AbortController();
    const { api, asked } = sourceOf(run);
    const told = (part: number) => part > 0.2 && ending.abort(new Error("given up"));
    await expect(exportRun(api, "7", { ...going, signal: ending.signal, told })).rejects.toThrow("given up");
    expect(asked).toEqual(["1-100"]);
  });

  it("is refused if it is too long, before anything of it is loaded", async () => {
    const { api, asked } = sourceOf({ ...run, steps: kMostSteps + 1 });
    await expect(exportRun(api, "7", going)).rejects.toThrow("100000 macro steps");
    expect(asked).toEqual([]);
  });
});

describe("the file", () => {
  const message = (time: number): McapMessage => ({ channel: { topic: "/images/a", schema: "foxglove.CompressedImage" }, time, value: { timestamp: { sec: 0, nsec: 0 }, frame_id: "a", data: "AAAA".repeat(100_000), format: "jpeg" } });
  const about = { metadata: {}, attachments: [] };
  it("is written in chunks, each of which leaves as it is complete", async () => {
    const found = await read(await writeMcap(inOrder([[1, 2, 3, 4, 5, 6].map(message)]), about));
    expect([found.messages.length, found.chunks]).toEqual([6, 2]);
  });
  it("is refused at its bound, and written below", async () => {
    const messages = () => inOrder([[1, 2, 3, 4, 5, 6].map(message)]);
    const { size } = await writeMcap(messages(), about);
    await expect(writeMcap(messages(), about, size - 1)).rejects.toThrow("larger than 2 MiB");
    expect((await writeMcap(messages(), about, size)).size).toBe(size);
  });
  it("has messages of all sources in order, of the same time those of the first source first", async () => {
    const of = (name: string, ...times: readonly number[]): readonly McapMessage[] => times.map((time) => ({ ...message(time), value: { name } }));
    const found = [];
    for await (const { time, value } of inOrder([of("a", 1, 4, 4), of("b"), of("c", 0, 1, 4, 9)])) found.push([time, (value as { readonly name: string }).name]);
    expect(found).toEqual([[0, "c"], [1, "a"], [1, "c"], [4, "a"], [4, "a"], [4, "c"], [9, "c"]]);
  });
});
