// Eight clients, each a process, edit one document on the real server, over connections that delay, lose and break: each computes the same
// document from its own copy, which is the one that the server has, and has again after it was killed. RACE_SEED and RACE_CROWD_EDITS (how
// many edits, undos and redos each makes), which are printed, repeat what they try; RACE_CROWD_SEEDS is how many seeds, from that one on.
import { randomUUID } from "node:crypto";
import { openEditor, type Editor } from "../../web/shared/edit/editor";
import { readExact } from "../../web/shared/edit/exact";
import { openStream } from "../../web/shared/stream";
import { setting } from "../../web/tests/edit/random";
import { openCrowd } from "./crowd";
import { hashOf } from "./crowdClient";
import { openFixture, type Fixture } from "./fixture";
import { NodeSocket } from "./nodeSocket";
import { kSoon } from "./patience";

const kClients = 8;
const kTimeout = 3_600_000;

let fixture: Fixture;
beforeAll(async () => {
  fixture = await openFixture();
});
afterAll(() => fixture.close());

interface Stored {
  readonly revision: number;
  readonly document: unknown;
}
const first = setting("RACE_SEED", 20261122);
const count = setting("RACE_CROWD_EDITS", 2000);
const seeds = Array.from({ length: setting("RACE_CROWD_SEEDS", 1) }, (_, i) => first + i);

it.each(seeds)(
  "eight clients, the server and its disk have the same document (seed %i)",
  async (seed) => {
    const name = `edited-${seed}`;
    const stored = async (): Promise<Stored> => (await (await fetch(`${fixture.url}/api/v1/documents/${name}`)).json()) as Stored;
    const crowd = openCrowd();
    onTestFinished(crowd.close);
    const text = '{"rcm": 1, "root": {"state": "Root", "parameters": [{"name": "kept", "value": 1.0, "meta": {"id": "kept"}}], "meta": {"id": "root"}}}';
    const put = await fetch(`${fixture.url}/api/v1/documents/${name}`, { method: "PUT", body: text, headers: { "content-type": "application/json" } });
    expect(put.ok).toBe(true);
    const clients = Array.from({ length: kClients }, (_, i) => crowd.open({ url: fixture.url, document: name, name: `c${i}`, seed: seed * kClients + i }));
    for (const client of clients) await client.report("ready");

    const begun = performance.now();
    clients.forEach((client) => client.command({ type: "edit", count }));
    const edited = await Promise.all(clients.map((client) => client.report("edited")));
    const { revision, document } = await stored();
    const hashes = async () => {
      clients.forEach((client) => client.command({ type: "read", revision }));
      return Promise.all(clients.map(async (client) => client.report("read")));
    };
    const read = await hashes();
    expect(new Set(read.map(({ hash }) => hash))).toEqual(new Set([hashOf(document)]));
    expect(read.flatMap(({ malformed }) => malformed)).toEqual([]);

    const sum = (of: (each: (typeof edited)[number]) => number) => edited.reduce((all, each) => all + of(each), 0);
    for (const { made, refused } of edited) {
      expect(made).toBe(count);
      expect(new Set(refused).size).toBe(refused.length);
    }
    // The first revision was put; each accepted edit made one.
    expect(revision - 1 + sum(({ refused }) => refused.length)).toBe(kClients * count);
    expect(sum(({ breaks }) => breaks)).toBeGreaterThan(0);
    console.log(
      `${revision - 1} accepted, ${sum(({ refused }) => refused.length)} refused, ${sum(({ undos }) => undos)} undos and redos, ${sum(({ breaks }) => breaks)} connections broken, ${((performance.now() - begun) / 1000).toFixed(0)} s`,
    );

    await fixture.kill();
    await fixture.restart();
    expect(hashOf((await stored()).document)).toBe(hashOf(document));
    expect((await hashes()).map(({ hash }) => hash), "they are connected again").toEqual(read.map(({ hash }) => hash));
  },
  kTimeout,
);

it("numbers stay as they were written and typed", async () => {
  vi.stubGlobal("WebSocket", NodeSocket);
  const parameters = '[{"name": "kept", "value": 1.0, "meta": {"id": "kept"}}, {"name": "typed", "value": 1, "meta": {"id": "typed"}}]';
  await fetch(`${fixture.url}/api/v1/documents/exact`, { method: "PUT", body: `{"rcm": 1, "root": {"state": "Root", "parameters": ${parameters}, "meta": {"id": "root"}}}`, headers: { "content-type": "application/json" } });
  const later: { editor?: Editor } = {};
  const stream = openStream(() => `${fixture.url.replace("http", "ws")}/api/v1/stream`, {
    onUpdate: (update) => later.editor?.receive(update),
    onConnection: (connection) => later.editor?.connection(connection),
    onMalformed: (error) => {
      throw error;
    },
  });
  const editor = openEditor(stream, "connecting", "exact", "Ann", { onSession: () => undefined, onNotice: () => undefined }, randomUUID);
  later.editor = editor;
  await expect.poll(() => editor.session().view, kSoon).toBeDefined();
  editor.edit({ operations: [{ op: "set", id: "typed", field: "value", value: readExact("2.0") }] });
  await expect.poll(() => editor.session().confirmed?.revision, kSoon).toBe(2);
  const exact = await (await fetch(`${fixture.url}/api/v1/documents/exact`)).text();
  expect(exact).toMatch(/"value": ?1\.0/);
  expect(exact).toMatch(/"value": ?2\.0/);
  stream.close();
  vi.unstubAllGlobals();
});
