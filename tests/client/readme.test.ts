// The how-to of api/typescript/README.md: its blocks, run one after the other against the demo, print what the page says.
import { spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { install, library } from "./installed";
import { project, Server } from "./servers";

const kBlock = /^```(js|text)\n(.*?)^```$/gms;

/** The WebSocket of the tests, as socket.mjs. */
function bundleSocket(folder: string): void {
  const socket = ["--bundle", "--platform=node", "--format=esm", "--log-level=warning", `--outfile=${join(folder, "socket.mjs")}`];
  const bundled = spawnSync(join(project, "web/node_modules/.bin/esbuild"), [join(project, "tests/browser/nodeSocket.ts"), ...socket], { encoding: "utf8" });
  if (bundled.status !== 0) throw new Error(bundled.stderr);
}

describe("the page of the client", () => {
  it("blocks print what the page says", async () => {
    expect(existsSync(join(library, "dist/index.js")), "run `npm run client` in web/").toBe(true);
    const blocks = [...readFileSync(join(library, "README.md"), "utf8").matchAll(kBlock)].map(([, kind = "", text = ""]) => ({ kind, text }));
    expect(blocks.length).toBeGreaterThan(15);
    const folder = mkdtempSync(join(tmpdir(), "race-client-"));
    const server = await Server.start(["--demo", join(project, "deploy/demo")]);
    try {
      install(folder);
      bundleSocket(folder);
      // As Node 18 is: without a WebSocket, which the page gives it, and without the Web Crypto API.
      const node18 = 'import { NodeSocket } from "./socket.mjs";\nglobalThis.WebSocket = NodeSocket;\ndelete globalThis.crypto;\n';
      const program = blocks.filter(({ kind }) => kind === "js").map(({ text }) => text).join("\n");
      writeFileSync(join(folder, "main.mjs"), node18 + program.replaceAll("http://127.0.0.1:8080", server.url));
      const { stdout, stderr } = spawnSync(process.execPath, ["main.mjs"], { cwd: folder, encoding: "utf8", timeout: 60_000 });
      expect(stderr).toBe("");
      expect(stdout).toBe(blocks.filter(({ kind }) => kind === "text").map(({ text }) => text).join(""));
    } finally {
      rmSync(folder, { recursive: true, force: true });
      await server.stop();
    }
  });
});
