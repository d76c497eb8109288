// A program of network.test.ts: what a client is answered over TLS, as JSON. Node reads the authority (NODE_EXTRA_CA_CERTS) as it starts.
import { Client, RaceError } from "../../api/typescript/src/index";
import { NodeSocket } from "../browser/nodeSocket";

const [, , url = "", token = "", document = ""] = process.argv;
const race = new Client(url, { token, webSocket: NodeSocket });

async function converse(): Promise<unknown> {
  await race.documents.put("ticking", JSON.parse(document) as object);
  const { id } = await race.cores.create("ticking", { last: 2 });
  await race.cores.start(id);
  const { results } = await race.cores.wait(id, { timeout: 20 });
  const names: string[] = [];
  for await (const { name } of race.documents.all()) names.push(name);
  return { results, names };
}
const said = async (asked: Promise<unknown>): Promise<unknown> =>
  asked.catch((error: unknown) => (error instanceof RaceError ? { status: error.status, code: error.code, mayBeDone: error.mayBeDone } : String(error)));

/** Of a core that is not there: only what keeps it from being asked for matters. */
const follow = async (): Promise<unknown> => (await race.cores.follow("987654")).take();

async function main(): Promise<void> {
  const answer = { conversation: await said(converse()), following: await said(follow()) };
  process.stdout.write(JSON.stringify(answer), () => process.exit());
}
void main();
