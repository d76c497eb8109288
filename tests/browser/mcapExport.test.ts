// Runs exported as MCAP for Foxglove: Pick, and one whose camera is looked at. The saved files are read back with the library that wrote them, and say
// what the server says of these runs.
import type { Download, Page } from "playwright-core";
import type { Derivation, Pose, Run, RunPictures, RunSamples, Timing, TraceStep } from "../../web/generated/messages";
import { product, rotated } from "../../web/shared/mcap/rotation";
import { onTopic, readMcap, type ReadFile } from "../../web/tests/mcap/readBack";
import { findings } from "./axe";
import { openFixture, type Fixture } from "./fixture";
import { kPatience, kSoon } from "./patience";

let fixture: Fixture;
let page: Page;

beforeAll(async () => {
  fixture = await openFixture();
  page = fixture.page;
  page.setDefaultTimeout(kPatience);
  await page.setViewportSize({ width: 1366, height: 768 });
});
afterAll(() => fixture.close());

const soon = (value: () => unknown) => expect.poll(value, kSoon);
const get = async <T>(path: string): Promise<T> => (await fixture.send("GET", path)) as T;

/** Makes a run and waits for its end, and until all that is recorded of it is stored. */
async function runToEnd(document: string): Promise<Run> {
  const { id } = (await fixture.send("POST", "/cores", { document })) as Run;
  await fixture.send("POST", `/cores/${id}/start`);
  await expect.poll(async () => (await get<Run>(`/runs/${id}`)).status, { timeout: 60_000 }).toMatch(/ended|faulted/);
  let before = -1;
  await soon(async () => {
    const { length } = (await get<RunSamples>(`/runs/${id}/samples`)).samples;
    const isSame = length === before;
    before = length;
    return isSame;
  }).toBe(true);
  return get<Run>(`/runs/${id}`);
}

/** Nothing of it is later [us]: its end is told by the millisecond, of a clock that may be corrected meanwhile. */
const endOf = ({ ended = NaN }: Run): number => 1000 * (ended + 3);

const row = (id: string) => page.getByRole("list", { name: "Stored runs" }).getByRole("listitem", { name: `Run ${id}`, exact: true });
const exporting = (id: string) => row(id).getByRole("group", { name: `Export of run ${id}` });

async function bytesOf(download: Download): Promise<Uint8Array> {
  const parts: Buffer[] = [];
  for await (const part of await download.createReadStream()) parts.push(part as Buffer);
  return new Uint8Array(Buffer.concat(parts));
}

/** Scripts that the page has loaded which write such files: few people need them. */
const writers = () => page.evaluate(() => performance.getEntriesByType("resource").filter(({ name }) => name.includes("exportMcap")).length);

/** Exports a run on the page, and reads the file that it saves. */
async function exported(id: string): Promise<ReadFile> {
  const [file] = await Promise.all([page.waitForEvent("download"), row(id).getByRole("button", { name: "Export MCAP" }).click()]);
  expect(file.suggestedFilename()).toBe(`run-${id}.mcap`);
  return readMcap(await bytesOf(file));
}

/** The calls in a proof tree, in its order. */
const callsIn = ({ service, operation, premises }: Derivation): readonly string[] => [...(service === undefined || operation === undefined ? [] : [`${service}.${operation}`]), ...premises.flatMap(callsIn)];

interface Transform {
  readonly parent_frame_id: string;
  readonly child_frame_id: string;
  readonly translation: { readonly x: number; readonly y: number; readonly z: number };
  readonly rotation: { readonly x: number; readonly y: number; readonly z: number; readonly w: number };
}

/** Where a frame is in the world. */
function placeOf(frame: string, all: readonly Transform[]): Pose {
  const found = all.find(({ child_frame_id }) => child_frame_id === frame);
  if (found === undefined) return { position: [0, 0, 0], orientation: [0, 0, 0, 1] };
  const { position, orientation } = placeOf(found.parent_frame_id, all);
  const { x, y, z, w } = found.rotation;
  const moved = rotated(orientation, [found.translation.x, found.translation.y, found.translation.z]);
  return { position: [position[0] + moved[0], position[1] + moved[1], position[2] + moved[2]], orientation: product(orientation, [x, y, z, w]) };
}

describe("Pick, exported for Foxglove", () => {
  let run: Run;
  let file: ReadFile;
  let steps: readonly TraceStep[];

  it("is saved from the list of runs, where its export says that it is done and what is missing", async () => {
    run = await runToEnd("pick");
    expect(run.outcome).toBe("success");
    steps = (await get<{ readonly steps: readonly TraceStep[] }>(`/runs/${run.id}/derivations?from=1&to=${run.steps}`)).steps;
    await page.goto(`${fixture.url}/pro/?runs=1`);
    await row(run.id).waitFor();
    expect(await writers()).toBe(0);
    file = await exported(run.id);
    expect(await writers()).toBeGreaterThan(0);
    await soon(() => exporting(run.id).getByRole("status").innerText()).toBe(`Saved as run-${run.id}.mcap. No pictures of cameras are recorded.`);
    expect(await findings(page)).toEqual([]);
    await fixture.screenshot("run-exported");
    await exporting(run.id).getByRole("button", { name: "Close" }).click();
    await soon(() => exporting(run.id).count()).toBe(0);
  });

  it("has a channel for each thing, with as many messages as the server has of it", async () => {
    const { samples } = await get<RunSamples>(`/runs/${run.id}/samples`);
    expect(samples.length).toBeGreaterThan(5);
    const calls = steps.reduce((sum, step) => sum + step.calls.length, 0);
    const counts = Object.fromEntries(["/tf", "/joint_states", "/race/inputs", "/race/derivations", "/race/state", "/race/calls", "/log"].map((topic) => [topic, onTopic(file, topic).length]));
    expect(counts).toEqual({ "/tf": samples.length, "/joint_states": samples.length, "/race/inputs": run.steps, "/race/derivations": run.steps, "/race/state": run.steps, "/race/calls": calls, "/log": run.steps + calls + 1 });
    const { services } = await get<Timing>(`/runs/${run.id}/timing`);
    const changes = onTopic(file, "/race/services").map(({ value, time }) => [value["service"], value["state"], time - 1000 * run.created]);
    expect(changes.length).toBeGreaterThan(8);
    // The server may have recorded one that came when the run was over.
    expect(changes).toEqual(services.slice(0, changes.length).map(({ service, state, time }) => [service, state, time]));
    expect(services.slice(changes.length).every(({ time }) => time > 1000 * ((run.ended ?? 0) - run.created))).toBe(true);
    expect([...new Set(file.messages.map(({ topic }) => topic))]).toHaveLength(8);
    expect(file.metadata).toMatchObject({ run: run.id, document: "pick", outcome: "success", chain: run.chain, steps: String(run.steps), steps_without_time: "0" });
    expect([...file.attachments.values()].join()).toContain("<robot ");
  });

  it("has times that never fall on any channel, and are those of the run", () => {
    const [begin, end] = [1000 * run.created, endOf(run)];
    for (const topic of new Set(file.messages.map((message) => message.topic))) {
      const all = onTopic(file, topic);
      expect(all.map(({ sequence }) => sequence)).toEqual(all.map((_, i) => i));
      expect(all.every(({ time }, i) => time >= (all[i - 1]?.time ?? begin))).toBe(true);
      expect(all.filter(({ time, published }) => published < begin || published > time || time > end).map(({ topic, time, published, value }) => [topic, published - begin, time - begin, time - end, value])).toEqual([]);
    }
    // The arm moves for some seconds: its poses are spread over them, as they were recorded.
    const poses = onTopic(file, "/joint_states").map(({ time }) => time);
    expect((poses.at(-1) ?? 0) - (poses[0] ?? 0)).toBeGreaterThan(2e6);
    const between = poses.slice(1).map((time, i) => time - (poses[i] ?? 0)).sort((a, b) => a - b);
    expect(between[Math.floor(between.length / 2)]).toBeGreaterThan(150_000);
    expect(Number(file.metadata["pose_time_doubt_s"])).toBeLessThan(1);
  });

  it("calls what the derivations call, in the same macro steps", () => {
    const told = onTopic(file, "/race/calls").map(({ value }) => [value["step"], value["call"], `${String(value["service"])}.${String(value["operation"])}`, value["args"], value["kwargs"]]);
    expect(told).toEqual(steps.flatMap(({ step, calls }) => calls.map(({ call, service, operation, args, kwargs }) => [step, call, `${service}.${operation}`, JSON.stringify(args), JSON.stringify(kwargs)])));
    expect(told.map(([, , name]) => name)).toContain("gripper.grasp");
    const derived = onTopic(file, "/race/derivations").flatMap(({ value }) => (value["micro"] as readonly { readonly tree: string }[]).flatMap(({ tree }) => callsIn(JSON.parse(tree) as Derivation)));
    for (const [, , name] of told) expect(derived).toContain(name);
  });

  it("says what was active, as the server does", () => {
    expect(onTopic(file, "/race/state").map(({ value }) => [value["step"], value["active"]])).toEqual(steps.map(({ step, state }) => [step, state?.active]));
    expect(onTopic(file, "/log").at(-1)?.value).toMatchObject({ level: 2, message: "Ended: success" });
  });

  it("has the joints at the end, and the frames that follow of them, as the server says them", async () => {
    const { samples } = await get<RunSamples>(`/runs/${run.id}/samples`);
    const last = onTopic(file, "/joint_states").at(-1)?.value["joints"] as readonly { readonly name: string; readonly position: number }[];
    expect(Object.fromEntries(last.map(({ name, position }) => [name, position]))).toEqual(samples.at(-1)?.pose.joints);
    // The arm has rested since: this is another way to ask for the same.
    const { result } = (await fixture.send("POST", "/services/robot/calls", { operation: "state" })) as { readonly result: { readonly q: readonly number[]; readonly pose: Pose } };
    for (const [i, at] of result.q.entries()) expect(Math.abs((last.find(({ name }) => name === `a${i + 1}`)?.position ?? NaN) - at)).toBeLessThan(0.01);
    const frames = onTopic(file, "/tf").at(-1)?.value["transforms"] as readonly Transform[];
    const tool = placeOf("tcp", frames);
    expect(Math.hypot(...tool.position.map((each, i) => each - (result.pose.position[i] ?? NaN)))).toBeLessThan(0.005);
    expect(Math.abs(tool.orientation.reduce((sum, each, i) => sum + each * (result.pose.orientation[i] ?? NaN), 0))).toBeGreaterThan(0.999);
    expect(frames.map(({ child_frame_id }) => child_frame_id)).toContain("body/cube_red");
  });
});

describe("a run whose camera is looked at", () => {
  /** It looks for parts until the recognition has seen some. */
  const looking = {
    state: "Root", first: "Look",
    children: [
      { state: "Look", entry: "svc.obj_rec.start()", exit: "svc.obj_rec.stop()", ports: [{ name: "seen", when: "svc.obj_rec.recognized_objects", to: "Rest" }] },
      { state: "Rest", entry: "svc.timer.wait(0.2)", ports: [{ name: "done", when: "svc.timer.wait.result" }] },
    ],
    ports: [{ name: "over", when: "chi.Rest.port.done" }],
  };

  it("has the pictures that the server has, at times within the run", async () => {
    await fixture.send("PUT", "/documents/looking", { rcm: 1, name: "looking", root: looking });
    const run = await runToEnd("looking");
    const { pictures } = await get<RunPictures>(`/runs/${run.id}/pictures`);
    expect(pictures.length).toBeGreaterThan(0);
    await page.goto(`${fixture.url}/pro/?runs=1`);
    const file = await exported(run.id);
    const service = pictures[0]?.service ?? "";
    const found = onTopic(file, `/images/${service}`);
    expect(found).toHaveLength(pictures.length);
    for (const [i, { value, time }] of found.entries()) {
      const { jpeg } = await get<{ readonly jpeg: string }>(`/runs/${run.id}/pictures/${pictures[i]?.number ?? ""}`);
      expect(value).toMatchObject({ frame_id: service, format: "jpeg", data: jpeg });
      expect(time >= 1000 * run.created && time <= endOf(run)).toBe(true);
    }
    await exporting(run.id).getByRole("button", { name: "Close" }).click();
  });

  it("is not saved if its export is cancelled", async () => {
    const { runs } = await get<{ readonly runs: readonly Run[] }>("/runs");
    const id = runs[0]?.id ?? "";
    await page.goto(`${fixture.url}/pro/?runs=1`);
    const samples = `**/api/v1/runs/${id}/samples`;
    let answer: () => void = () => undefined;
    const held = new Promise<void>((resolve) => (answer = resolve));
    await page.route(samples, async (route) => {
      await held;
      await route.continue();
    });
    let saved = 0;
    page.on("download", () => saved++);
    const asked = page.waitForRequest(samples);
    await row(id).getByRole("button", { name: "Export MCAP" }).click();
    await exporting(id).getByRole("progressbar", { name: `Exporting run ${id}` }).waitFor();
    await asked;
    await exporting(id).getByRole("button", { name: "Cancel" }).click();
    await soon(() => exporting(id).count()).toBe(0);
    const answered = page.waitForResponse(samples);
    answer();
    await (await answered).finished();
    await page.unroute(samples);
    // A second one goes on after what the first one would have done, and is the only one that is saved.
    await exported(id);
    await soon(() => exporting(id).getByRole("status").innerText()).toContain("Saved as");
    expect(saved).toBe(1);
  });
});
