// The conversations of api/conversations, which the clients of all languages hold.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { allConversations, Conversation } from "./conversation";
import { folder, mismatch, Values, type Fields } from "./conversationValues";
import { folderWithAccounts, kRoles, project, Server, tokenOf, type Account } from "./servers";
import type { ExactJson } from "../../api/typescript/src/index";

/** A new server, and tokens of its accounts. */
async function start(kind: "plain" | "accounts" | "demo" = "plain"): Promise<{ readonly server: Server; readonly tokens: ReadonlyMap<Account, string> }> {
  if (kind !== "accounts") return { server: await Server.start(kind === "demo" ? ["--demo", join(project, "deploy/demo")] : []), tokens: new Map() };
  const data = folderWithAccounts();
  const tokens = new Map(kRoles.map((account) => [account, tokenOf(data, account)]));
  return { server: await Server.start([], { data }), tokens };
}

describe("conversations", () => {
  const conversations = allConversations();
  it.each(conversations.map(({ title, ...rest }) => [title, rest] as const))("%s", async (_, { server: kind, steps }) => {
    const { server, tokens } = await start(kind);
    const clientOf = (account: Account | undefined) => server.client({ token: account && tokens.get(account) });
    try {
      await new Conversation(clientOf).hold(steps);
    } finally {
      await server.stop();
    }
  });
});

describe("patterns", () => {
  const { patterns, saved } = JSON.parse(readFileSync(join(folder, "format/patterns.json"), "utf8")) as { readonly patterns: readonly (readonly [ExactJson, ExactJson, boolean])[]; readonly saved: Fields };
  const values = new Values();
  for (const [name, value] of Object.entries(saved)) values.set(name, value);
  it.each(patterns)("%j of %j: %s", (pattern, value, fits) => expect(mismatch(pattern, value, values) === undefined).toBe(fits));
});
