// Servers for the conversations: `race serve` on a free port with its own data folder; also with accounts, and in the network.
import { execFileSync, spawn, type ChildProcess } from "node:child_process";
import { createWriteStream, existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createServer, type AddressInfo } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { fileURLToPath } from "node:url";
import { Client, type ClientOptions } from "../../api/typescript/src/index";
import { NodeSocket } from "../browser/nodeSocket";

export const project = fileURLToPath(new URL("../../", import.meta.url));
export const binary = process.env["RACE_BINARY"] ?? join(project, "build/release/race");

/** In memory: a disk that is busy with something else would interrupt runs. */
export const newFolder = (): string => mkdtempSync(join(existsSync("/dev/shm") ? "/dev/shm" : tmpdir(), "race-client-"));

export class Server {
  private constructor(
    readonly data: string,
    private readonly process: ChildProcess,
    readonly port: number,
    /** What it has written to its standard error. */
    readonly log: string,
  ) {}

  static async start(options: readonly string[] = [], { data = newFolder(), port = 0 }: { readonly data?: string; readonly port?: number } = {}): Promise<Server> {
    const log = join(data, "test-server.log");
    const child = spawn(binary, ["serve", "--port", String(port), "--data", data, ...options], { stdio: ["ignore", "pipe", "pipe"] });
    child.stderr.pipe(createWriteStream(log, { flags: "a" }));
    const first = await new Promise<string>((resolve, reject) => {
      createInterface({ input: child.stdout }).once("line", resolve).once("close", () => reject(new Error("the server did not start")));
      child.once("error", reject);
    });
    const [, found] = /:(\d+)$/.exec(first.trim()) ?? [];
    if (found === undefined) throw new Error(`the server did not start: ${first}`);
    return new Server(data, child, Number(found), log);
  }

  get url(): string {
    return `http://127.0.0.1:${this.port}`;
  }

  /** A client of it; Node 18 has no WebSocket. */
  client(options: ClientOptions = {}): Client {
    return new Client(this.url, { webSocket: NodeSocket, ...options });
  }

  /** SIGSTOP lets it be silent, SIGCONT go on. */
  signal(signal: NodeJS.Signals): void {
    this.process.kill(signal);
  }

  /** Ends it by SIGKILL; the data folder stays. */
  async kill(): Promise<void> {
    await this.end("SIGKILL");
  }

  /** Ends it as a service manager does; the data folder goes. */
  async stop(): Promise<void> {
    await this.end("SIGTERM");
    rmSync(this.data, { recursive: true, force: true });
  }

  private async end(signal: NodeJS.Signals): Promise<void> {
    const ended = new Promise((resolve) => this.process.once("exit", resolve));
    if (this.process.exitCode === null && this.process.signalCode === null && this.process.kill(signal)) await ended;
  }
}

const kPassword = "correct horse battery";
export const kRoles = ["admin", "developer", "operator", "observer"] as const; // the first is an admin
/** Named as its role. */
export type Account = (typeof kRoles)[number];

const account = (data: string, ...words: readonly string[]): string =>
  execFileSync(binary, ["account", ...words, "--data", data], { input: `${kPassword}\n`, encoding: "utf8" }).trim();

/** A token of an account, from the command line, before a server has the folder. */
export const tokenOf = (data: string, name: Account): string => account(data, "token", name);

/** A new data folder with an account of each role, named as its role. */
export function folderWithAccounts(): string {
  const data = newFolder();
  for (const role of kRoles) account(data, "add", role, "--role", role);
  return data;
}

function freePort(): Promise<number> {
  return new Promise((resolve) => {
    const probe = createServer();
    probe.listen(0, "127.0.0.1", () => {
      const { port } = probe.address() as AddressInfo;
      probe.close(() => resolve(port));
    });
  });
}

export interface NetworkServer {
  readonly server: Server;
  /** Where the network reaches it. */
  readonly url: string;
  /** File of its certificate authority. */
  readonly authority: string;
  /** Of an admin. */
  readonly token: string;
}

export async function startInNetwork(): Promise<NetworkServer> {
  const data = folderWithAccounts();
  const token = tokenOf(data, "admin");
  const port = await freePort();
  const server = await Server.start(["--lan", "--lan-port", String(port)], { data });
  const log = (): string => readFileSync(server.log, "utf8");
  for (const end = Date.now() + 20_000; !log().includes("its authority"); await new Promise((resolve) => setTimeout(resolve, 10))) {
    if (Date.now() > end) throw new Error(`the server does not say where its network is: ${log()}`);
  }
  const addresses = [...log().matchAll(/serves the network at (https:\/\/\S+)$/gm)].map(([, url = ""]) => url);
  const url = addresses.find((each) => !new URL(each).hostname.endsWith(".local"));
  if (url === undefined) throw new Error("no address of the network reaches the server");
  return { server, url, authority: join(data, "tls", "ca.pem"), token };
}
