// Conversations over TLS.
import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { Client } from "../../api/typescript/src/index";
import { task } from "./models";
import { project, startInNetwork, type NetworkServer } from "./servers";

const folder = mkdtempSync(join(tmpdir(), "race-client-"));
const program = join(folder, "client.mjs");
let network: NetworkServer;
beforeAll(async () => {
  const bundled = spawnSync(join(project, "web/node_modules/.bin/esbuild"), [join(project, "tests/client/secureClient.ts"), "--bundle", "--platform=node", "--format=esm", "--log-level=warning", `--outfile=${program}`], { encoding: "utf8" });
  if (bundled.status !== 0) throw new Error(bundled.stderr);
  network = await startInNetwork();
});
afterAll(async () => {
  rmSync(folder, { recursive: true, force: true });
  await network.server.stop();
});

/** What a client says that knows this authority, if any. */
function said(authority?: string): unknown {
  const { NODE_EXTRA_CA_CERTS: _, ...others } = process.env;
  const env = authority === undefined ? others : { ...others, NODE_EXTRA_CA_CERTS: authority };
  const { stdout } = spawnSync(process.execPath, [program, network.url, network.token, JSON.stringify(task("ticking"))], { env, encoding: "utf8", timeout: 60_000 });
  return JSON.parse(stdout);
}

/** Node 18 holds an IPv6 address against the names of a certificate, so it knows no server by one (api/typescript/README.md). */
const knowsNoneByAddress = (): boolean => Number.parseInt(process.versions.node) < 20 && new URL(network.url).hostname.startsWith("[");

const kUnknown = { status: 0, code: "certificate", mayBeDone: false };

describe("tls", () => {
  it("a server is known by its authority", () => {
    if (knowsNoneByAddress()) expect(said(network.authority)).toEqual({ conversation: kUnknown, following: kUnknown });
    else expect(said(network.authority)).toMatchObject({ conversation: { results: { n: 2 }, names: ["ticking"] }, following: { status: 0, code: "not_found" } });
  });

  it("a server that is not known gets nothing", () => {
    expect(said()).toEqual({ conversation: kUnknown, following: kUnknown });
  });

  it("a wrong address is said before anything is sent", () => {
    const wrong = ["http://192.0.2.1:8080", "ftp://127.0.0.1", "127.0.0.1:8080", "http://127.0.0.1:8080/api", "http://a:b@127.0.0.1", "http://127.0.0.1/?x", ""];
    for (const url of wrong) expect(() => new Client(url), url).toThrow(TypeError);
    for (const url of ["http://127.0.0.1:8080/", "http://[::1]:8080", "http://localhost", "https://192.0.2.1:8443"]) expect(() => new Client(url), url).not.toThrow();
  });
});
