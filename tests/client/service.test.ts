// Services of one's own in TypeScript (race-client/service): programs at a server. The same of Python are in tests/integration/test_python_service.py.
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { ServiceError, type Client, type JsonValue, type messages } from "../../api/typescript/src/index";
import { untilOver } from "./asserting";
import { calling, eventually, lineOf, Program, programText } from "./serviceProgram";
import { Server } from "./servers";

/** For tests in which nothing hangs: a machine under load may be slow. */
const kLongHeartbeat = ["--heartbeat", "30"];

let server: Server;
let race: Client;
let program: Program;
const ends: (() => unknown)[] = [];
afterEach(async () => {
  for (const end of ends.splice(0).reverse()) await end();
});

async function serve(options: readonly string[] = kLongHeartbeat, folder?: { readonly data: string; readonly port: number }): Promise<void> {
  server = await Server.start(options, folder);
  const mine = server;
  ends.push(() => mine.stop());
  race = server.client();
}

/** A server, and the program with its services, which are available. */
async function start(options?: readonly string[], folder?: { readonly data: string; readonly port: number }): Promise<void> {
  await serve(options, folder);
  program = make().start();
  await available("grip");
}

function make(text?: string): Program {
  const made = new Program(server, text);
  ends.push(() => made.remove());
  return made;
}

async function shown(key = "grip"): Promise<messages.HostedService | undefined> {
  return (await race.services.all()).find((each) => each.key === key);
}
const available = (key: string, is = true): Promise<void> => eventually(async () => ((await shown(key))?.available ?? false) === is, () => `${key}: ${program.said}`);
const moving = (): Promise<void> => eventually(async () => (await shown())?.state === "Moving");

async function begin(call: string, name?: string): Promise<string> {
  const document = calling(call, name);
  await race.documents.put(document.name, document);
  const { id } = await race.cores.create(document.name);
  await race.cores.start(id);
  return id;
}

async function results(call: string, name?: string): Promise<Readonly<Record<string, unknown>>> {
  return resultsOf(await begin(call, name));
}
const resultsOf = async (core: string): Promise<Readonly<Record<string, unknown>>> => ({ ...(await untilOver(race, core)).results });

const call = (operation: string, named: Readonly<Record<string, JsonValue>> = {}): Promise<JsonValue> => race.services.call("grip", operation, [], named);
const failed = async (operation: string): Promise<ServiceError> =>
  await call(operation).then(
    (answer) => Promise.reject(new Error(`it is answered ${JSON.stringify(answer)}`)),
    (error: unknown) => (error instanceof ServiceError ? error : Promise.reject(error as Error)),
  );

describe("programs", () => {
  it("its rsm is made of the class", async () => {
    await start();
    const rsm = (await shown())?.rsm;
    const [move, stop] = rsm?.operations ?? [];
    expect(rsm?.operations.map(({ name }) => name)).toEqual(["move", "stop", "count", "lie", "wrong", "fail", "nothing", "think"]);
    const width = { name: "width", type: "number", unit: "m", min: 0, max: 0.11 };
    expect(move).toEqual({ name: "move", doc: "Moves the fingers.", error: "any", moves: true, parameters: [width, { name: "speed", type: "number", value: 0.1 }] });
    expect([stop?.safe, rsm?.meta, rsm?.init, rsm?.states?.map(({ name }) => name)]).toEqual([true, { version: "1.2" }, "Ready", ["Ready", "Moving"]]);
  });

  it("its methods answer calls and it keeps to its rsm", async () => {
    await start();
    expect((await results("svc.grip.move(0.002, speed=0.2)"))["value"]).toEqual({ width: 0.002, speed: 0.2 });
    expect((await results("svc.grip.move(0.01)"))["error"]).toEqual({ code: "jammed", message: "the fingers are jammed", force: 5.5 });
    expect((await results("svc.grip.move(0.2)"))["error"]).toMatchObject({ code: "out_of_range", argument: "width" });
    expect((await results("svc.grip.move('far')"))["error"]).toMatchObject({ code: "invalid" });
    expect((await results("svc.grip.think(0.01)"))["value"]).toBe("Ready");
    expect(await call("count")).toBe(0);
    const grip = await shown();
    expect([grip?.state, grip?.pending]).toEqual(["Ready", []]);
    expect(grip?.violations.map(({ rule }) => rule), "the argument of a task that is a text").toEqual(["type"]);
  });

  it("while it is busy it rejects answers what reads and is stopped", async () => {
    await start();
    const core = await begin("svc.grip.move(0.1)", "moving");
    await moving();
    expect((await results("svc.grip.move(0.001)", "second"))["error"], "another run has it").toMatchObject({ code: "leased" });
    expect(await call("count")).toBe(0);
    expect(await call("think", { seconds: 0.01 })).toBe("Moving");
    expect(await call("stop")).toBe(null);
    expect((await resultsOf(core))["error"]).toEqual({ code: "stopped" });
    const begun = Date.now();
    expect((await results("svc.grip.move(0.001)"))["value"]).toMatchObject({ width: 0.001 });
    expect(Date.now() - begun, "the work that was stopped has ended, which this one waits for").toBeLessThan(3000);
    expect((await shown())?.violations).toEqual([]);
  });

  it("calls that may be concurrent are answered when each is done", async () => {
    await start();
    const late = await begin("svc.patience.wait(0.6)", "late");
    const soon = await begin("svc.patience.wait(0.1)", "soon");
    expect((await resultsOf(soon))["value"]).toBe(0.1);
    expect((await race.cores.get(late)).status).toBe("running");
    expect((await resultsOf(late))["value"]).toBe(0.6);
    expect((await shown("patience"))?.violations).toEqual([]);
  });

  it("a call that is taken in every state and answered later has the result of its method", async () => {
    await start();
    expect((await resultsOf(await begin("svc.patience.begin()", "beginning")))["value"]).toBe("begun");
    expect((await shown("patience"))?.violations).toEqual([]);
  });

  it("a violation is shown at the line of its declaration", async () => {
    await start();
    await call("lie");
    await program.waitFor(new RegExp(`gripper\\.mjs:${lineOf("events = ")}: violation: type: event \`moved\`: `));
    expect(await call("wrong")).toBe("far");
    await program.waitFor(new RegExp(`gripper\\.mjs:${lineOf("wrong = ")}: violation: type: result of \`wrong\`: .*\\(call \\d+\\)`));
  });

  it("a method that fails is an error and shown", async () => {
    await start();
    const error = await failed("fail");
    expect([error.code, error.message]).toEqual(["failed", "RangeError: nothing"]);
    await program.waitFor(new RegExp(`gripper\\.mjs:${lineOf("fail = ")}: error: \`fail\` has failed\nRangeError: nothing\n +at .*gripper\\.mjs:${lineOf("throw new RangeError")}`));
    expect((await failed("nothing")).message, "no JSON").toBe("RangeError: JSON has no NaN");
    expect(await call("count")).toBe(0);
  });

  it("it halts when the server is lost and connects again", async () => {
    await start();
    const { data, port } = server;
    await begin("svc.grip.move(0.1)", "moving");
    await moving();
    await server.kill();
    await program.waitFor(/grip, patience: /);
    await serve(kLongHeartbeat, { data, port });
    await available("grip");
    expect(await call("count"), "`stop` was called, as it is safe").toBe(1);
    expect((await shown())?.state).toBe("Ready");
    await program.waitFor(/grip: connected/, 2);
  });

  it("it halts when the server is silent and goes on", async () => {
    await start(["--heartbeat", "1"]);
    await begin("svc.grip.move(0.1)", "moving");
    await moving();
    const mine = server;
    ends.push(() => mine.signal("SIGCONT"));
    server.signal("SIGSTOP");
    await program.waitFor(/the server is silent: services halt/);
    server.signal("SIGCONT");
    await available("grip");
    await eventually(async () => Number(await call("count").catch(() => 0)) >= 1);
  });

  it("ends on sigterm and is gone", async () => {
    await start();
    const core = await begin("svc.grip.move(0.1)", "moving");
    await moving();
    expect(await program.end()).toBe(0);
    await available("grip", false);
    expect((await resultsOf(core))["error"]).toMatchObject({ code: "unavailable" });
  });

  it("who is refused ends with the reason and the line", async () => {
    await serve();
    program = make(programText.replace('key = "grip"', 'key = "timer"')).start();
    expect(await program.ended()).toBe(2);
    expect(program.said).toMatch(new RegExp(`gripper\\.mjs:${lineOf("class Gripper")}: error: timer: not_found: no service of this key waits`));
    const nobody = make().start({ options: ["--token-file", "/nowhere"] });
    expect(await nobody.ended()).toBe(2);
    expect(nobody.said).toContain("/nowhere");
    const other = make().start({ options: ["--speed", "1"] });
    expect(await other.ended()).toBe(2);
    expect(other.said).toContain("--token-file FILE");
  });

  it("a process that is not known is refused and ends", async () => {
    await serve();
    program = make();
    writeFileSync(join(program.folder, "stranger.token"), "stranger");
    program.start({ options: ["--token-file", "stranger.token"] });
    expect(await program.ended()).toBe(2);
    expect(program.said).toMatch(new RegExp(`gripper\\.mjs:${lineOf("class Gripper")}: error: grip: rights: who is no process`));
  });

  it("saved code is taken over and a slip is not", async () => {
    await serve();
    program = make().start({ options: ["--reload"] });
    await available("grip");
    program.save(programText.replace('"1.2"', '"1.3"').replace("count = ", "number = "));
    await eventually(async () => {
      const grip = await shown();
      return grip?.available === true && JSON.stringify(grip.rsm.meta) === '{"version":"1.3"}';
    });
    expect((await shown())?.rsm.operations.map(({ name }) => name)).toContain("number");
    program.save(`${programText}\nbroken(:\n`);
    const slip = programText.split("\n").length + 1;
    await program.waitFor(new RegExp(`gripper\\.mjs:${slip}: error: SyntaxError: .*; what was saved before goes on`));
    expect((await shown())?.available).toBe(true);
    program.save("process.exit(3);\n");
    await program.waitFor(/it has ended with status 3/);
    await available("grip", false);
    program.replace(programText);
    await eventually(async () => JSON.stringify((await shown())?.rsm.meta) === '{"version":"1.2"}');
    await available("grip");
    const rsm = join(program.folder, "patience.rsm.json");
    writeFileSync(rsm, readFileSync(rsm, "utf8").replace('"name": "patience"', '"name": "waiting"'));
    await eventually(async () => (await shown("patience"))?.rsm.name === "waiting");
    expect(await program.end("SIGINT")).toBe(0);
    await available("grip", false);
  });

  const version = (is: string): Promise<void> =>
    eventually(async () => {
      const grip = await shown();
      return grip?.available === true && JSON.stringify(grip.rsm.meta) === JSON.stringify({ version: is });
    }, () => program.said);

  it("what is saved while it starts is taken over", async () => {
    await serve();
    const saving = `import { existsSync, readFileSync, writeFileSync } from "node:fs";
if (!process.argv.includes("--reload") && !existsSync("saved")) {
  writeFileSync("saved", "");
  writeFileSync("gripper.mjs", readFileSync("gripper.mjs", "utf8").replaceAll('"1.2"', '"1.3"'));
}
`;
    program = make(saving + programText).start({ options: ["--reload"] });
    await version("1.3");
  });

  it("it does not begin anew while another file has a slip", async () => {
    await serve();
    program = make().start({ options: ["--reload"] });
    await version("1.2");
    const other = join(program.folder, "other.json");
    writeFileSync(other, "{");
    await program.waitFor(/other\.json:1: error: /);
    program.save(programText.replace('"1.2"', '"1.3"'));
    await program.waitFor(/other\.json:1: error: /, 2);
    writeFileSync(other, "{}");
    await version("1.3");
    expect(program.said.match(/saved: begins anew/g)).toHaveLength(1);
  });
});
