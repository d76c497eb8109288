// Eight clients edit one document on the real server, with connections that break: all end with the document that the server has, and has
// again after a restart. RACE_SEED and RACE_CROWD_EDITS (how many edits they make together), which are printed, repeat a run.
import { createHash } from "node:crypto";
import { openEditor, type Editor } from "../../web/shared/edit/editor";
import { readExact } from "../../web/shared/edit/exact";
import type { Notice } from "../../web/shared/edit/session";
import { documentOf } from "../../web/shared/edit/tree";
import { openStream, type Stream } from "../../web/shared/stream";
import { textOf } from "../../web/tests/edit/documents";
import { randomOf, setting } from "../../web/tests/edit/random";
import { RandomEdits } from "../../web/tests/edit/randomEdits";
import { openFixture, type Fixture } from "./fixture";
import { NodeSocket } from "./nodeSocket";

const kName = "edited";
const kClients = 8;

let fixture: Fixture;
beforeAll(async () => {
  fixture = await openFixture();
  vi.stubGlobal("WebSocket", NodeSocket);
});
afterAll(async () => {
  vi.unstubAllGlobals();
  await fixture.close();
});

interface Client {
  readonly editor: Editor;
  readonly stream: Stream;
  readonly made: string[];
  readonly notices: Notice[];
}

function openClient(url: string, name: string, malformed: unknown[]): Client {
  const made: string[] = [];
  const notices: Notice[] = [];
  const later: { editor?: Editor } = {};
  const stream = openStream(`${url.replace("http", "ws")}/api/v1/stream`, {
    onUpdate: (update) => later.editor?.receive(update),
    onConnection: (connection) => later.editor?.connection(connection),
    onMalformed: (error) => malformed.push(error),
  });
  const newToken = () => {
    made.push(`${name}-${made.length}`);
    return made.at(-1) ?? "";
  };
  const editor = openEditor(stream, "connecting", kName, name, { onSession: () => undefined, onNotice: (notice) => notices.push(notice) }, newToken);
  later.editor = editor;
  return { editor, stream, made, notices };
}

const hashOf = (document: unknown): string => createHash("sha256").update(textOf(document)).digest("hex");
const pause = (ms: number) => new Promise((resolve) => setTimeout(resolve, ms));

async function until(what: string, holds: () => boolean): Promise<void> {
  for (let i = 0; i < 600 && !holds(); ++i) await pause(50);
  expect(holds(), what).toBe(true);
}

interface Stored {
  readonly revision: number;
  readonly document: unknown;
}
const stored = async (): Promise<Stored> => (await (await fetch(`${fixture.url}/api/v1/documents/${kName}`)).json()) as Stored;
const storedText = async (): Promise<string> => (await fetch(`${fixture.url}/api/v1/documents/${kName}`)).text();

it("eight clients, the server and its disk have the same document", async () => {
  const random = randomOf(setting("RACE_SEED", 20261122));
  const edits = setting("RACE_CROWD_EDITS", 400);
  const parameters = '[{"name": "kept", "value": 1.0, "meta": {"id": "kept"}}, {"name": "typed", "value": 1, "meta": {"id": "typed"}}]';
  const text = `{"rcm": 1, "root": {"state": "Root", "parameters": ${parameters}, "meta": {"id": "root"}}}`;
  const put = await fetch(`${fixture.url}/api/v1/documents/${kName}`, { method: "PUT", body: text, headers: { "content-type": "application/json" } });
  expect(put.ok).toBe(true);

  const malformed: unknown[] = [];
  const clients = Array.from({ length: kClients }, (_, i) => openClient(fixture.url, `c${i}`, malformed));
  const sources = clients.map((_, i) => new RandomEdits(random, `n${i}-`));
  await until("all have a snapshot", () => clients.every(({ editor }) => editor.session().view !== undefined));

  clients[0]?.editor.edit({ operations: [{ op: "set", id: "typed", field: "value", value: readExact("2.0") }] });
  await until("it is accepted", () => clients[0]?.editor.session().pending.length === 0);
  const exact = await storedText();
  expect(exact).toMatch(/"value": ?1\.0/);
  expect(exact).toMatch(/"value": ?2\.0/);

  for (let i = 0; i < edits; ++i) {
    const at = random.pick(kClients);
    const { view, pending } = clients[at]?.editor.session() ?? {};
    if (view !== undefined && (pending?.length ?? 0) < 20) {
      const change = random.chance(0.15) ? ({ undo: true } as const) : random.chance(0.1) ? ({ redo: true } as const) : sources[at]?.edit(view);
      if (change !== undefined) clients[at]?.editor.edit(change);
    }
    if (random.chance(0.03) && NodeSocket.all.size > 0) random.of([...NodeSocket.all]).break();
    if (random.chance(0.3)) await pause(random.pick(10));
  }
  const answered = () => clients.every(({ editor }) => editor.session().connected && editor.session().pending.length === 0);
  await until("everything is answered", answered);
  const { revision, document } = await stored();
  await until("all have the last revision", () => clients.every(({ editor }) => editor.session().confirmed?.revision === revision));

  const hashes = clients.map(({ editor }) => editor.session().view).map((view) => view && hashOf(documentOf(view)));
  expect(new Set(hashes)).toEqual(new Set([hashOf(document)]));
  expect(malformed).toEqual([]);
  const refused = clients.flatMap(({ notices }) => notices.map(({ request }) => request));
  expect(new Set(refused).size).toBe(refused.length);
  // The first revision was put; each accepted edit made one.
  expect(revision - 1 + refused.length).toBe(clients.reduce((sum, { made }) => sum + made.length, 0));
  console.log(`${revision - 1} accepted, ${refused.length} refused`);

  await fixture.kill();
  await fixture.restart();
  expect(hashOf((await stored()).document)).toBe(hashOf(document));
  const again = () => clients.every(({ editor }) => editor.session().connected && editor.session().confirmed?.revision === revision);
  await until("all are connected again", again);
  expect(clients.map(({ editor }) => editor.session().view).map((view) => view && hashOf(documentOf(view)))).toEqual(hashes);
  clients.forEach(({ stream }) => stream.close());
});
