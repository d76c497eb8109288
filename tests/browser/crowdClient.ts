// A client of editing.test.ts, a process: edits a document at random over a network that delays, loses what is on its way, and breaks. It is
// told by lines of JSON on its standard input what to do, and tells by such lines what it has.
import { createHash } from "node:crypto";
import { createInterface } from "node:readline";
import { openEditor, type Editor } from "../../web/shared/edit/editor";
import { documentOf } from "../../web/shared/edit/tree";
import { openStream } from "../../web/shared/stream";
import { textOf } from "../../web/tests/edit/documents";
import { randomOf } from "../../web/tests/edit/random";
import { RandomEdits } from "../../web/tests/edit/randomEdits";
import { NodeSocket } from "./nodeSocket";

/** What a client is started with (argument 1, as JSON). */
export interface CrowdSetup {
  readonly url: string;
  readonly document: string;
  readonly name: string;
  readonly seed: number;
}

/** `edit`: so many edits, undos and redos, until all are answered. `read`: the document of this revision. */
export type CrowdCommand = { readonly type: "edit"; readonly count: number } | { readonly type: "read"; readonly revision: number };

export type CrowdReport =
  | { readonly type: "ready" }
  | { readonly type: "edited"; readonly made: number; readonly refused: readonly string[]; readonly breaks: number; readonly undos: number }
  | { readonly type: "read"; readonly hash: string; readonly malformed: readonly string[] };

export const hashOf = (document: unknown): string => createHash("sha256").update(textOf(document)).digest("hex");

const pause = (ms: number) => new Promise((resolve) => setTimeout(resolve, ms));

/** About so many elements has the document: what an edit costs grows with them. */
const kElements = 150;
/** So many edits wait for the server at most. */
const kPending = 20;
/** Of a message, each way: usually up to a few, sometimes many [ms]. */
const kDelay = { usual: 8, long: 150, chance: 0.01 };

function runClient({ url, document, name, seed }: CrowdSetup): void {
  const random = randomOf(seed);
  const delay = () => (random.chance(kDelay.chance) ? random.pick(kDelay.long) : random.pick(kDelay.usual));
  const tell = (report: CrowdReport) => process.stdout.write(`${JSON.stringify(report)}\n`);

  /** Messages arrive late, in their order; those that are on their way when the connection breaks are lost. */
  class SlowSocket extends NodeSocket {
    private out = Promise.resolve();
    private in = Promise.resolve();
    override send(text: string): void {
      const wait = delay();
      this.out = this.out.then(() => pause(wait)).then(() => this.readyState === NodeSocket.OPEN && super.send(text)).then(() => undefined);
    }
    protected override deliver(data: string): void {
      const wait = delay();
      this.in = this.in.then(() => pause(wait)).then(() => this.readyState === NodeSocket.OPEN && super.deliver(data)).then(() => undefined);
    }
  }
  Object.assign(globalThis, { WebSocket: SlowSocket });

  const malformed: string[] = [];
  const refused: string[] = [];
  const later: { editor?: Editor } = {};
  const stream = openStream(() => `${url.replace("http", "ws")}/api/v1/stream`, {
    onUpdate: (update) => later.editor?.receive(update),
    onConnection: (connection) => later.editor?.connection(connection),
    onMalformed: (error) => malformed.push(String(error)),
  });
  let made = 0;
  const editor = openEditor(stream, "connecting", document, name, { onSession: () => undefined, onNotice: ({ request }) => refused.push(request) }, () => `${name}-${made++}`);
  later.editor = editor;
  const edits = new RandomEdits(random, `${name}-`, kElements);
  const until = async (holds: () => boolean) => {
    while (!holds()) await pause(20);
  };
  const isAnswered = () => editor.session().connected && editor.session().pending.length === 0;

  async function edit(count: number): Promise<void> {
    let [breaks, undos] = [0, 0];
    while (made < count) {
      const { view, pending } = editor.session();
      if (view === undefined || pending.length >= kPending) {
        await pause(5);
        continue;
      }
      const takesBack = random.chance(0.15) ? ({ undo: true } as const) : random.chance(0.1) ? ({ redo: true } as const) : undefined;
      if (takesBack !== undefined) ++undos;
      editor.edit(takesBack ?? edits.edit(view));
      if (random.chance(0.01))
        for (const socket of NodeSocket.all) {
          socket.break();
          ++breaks;
        }
      await pause(random.chance(0.3) ? random.pick(10) : 0);
    }
    await until(isAnswered);
    tell({ type: "edited", made, refused, breaks, undos });
  }

  async function read(revision: number): Promise<void> {
    await until(() => isAnswered() && editor.session().confirmed?.revision === revision);
    const { view } = editor.session();
    tell({ type: "read", hash: view === undefined ? "" : hashOf(documentOf(view)), malformed });
  }

  createInterface({ input: process.stdin })
    .on("line", (line) => {
      const command = JSON.parse(line) as CrowdCommand;
      void (command.type === "edit" ? edit(command.count) : read(command.revision));
    })
    .on("close", () => process.exit());
  void until(() => editor.session().view !== undefined).then(() => tell({ type: "ready" }));
}

const [, , setup] = process.argv;
if (setup?.startsWith("{") === true) runClient(JSON.parse(setup) as CrowdSetup);
