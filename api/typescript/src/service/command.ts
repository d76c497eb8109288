// Services as a program: its command line, and its end.
import { existsSync, readFileSync } from "node:fs";
import { parseArgs } from "node:util";
import { checkedToken, originOf } from "../address.js";
import { RaceError } from "../errors.js";
import { keepConnected, type ServiceServer, type ServiceSocketConstructor } from "./connection.js";
import { Hosted, type Log } from "./hosted.js";
import { kReload, runAnewWhenSaved } from "./reload.js";
import type { Service } from "./service.js";
import { messageOf } from "./values.js";

const kServer = "http://127.0.0.1:8080";
/** Of a server that runs in the same folder. */
const kTokenFile = "data/processes.token";
const kUsage = `Offers services at a server of RACE.
  --server URL       where it runs (${kServer})
  --token-file FILE  the token of the process; else RACE_TOKEN, else ${kTokenFile}
  --${kReload}           begins anew when a .js, .mjs, .cjs or .json file beside it is saved
The authority of an https server, tls/ca.pem of its data folder, is named by NODE_EXTRA_CA_CERTS=FILE.`;

export interface RunOptions {
  /** Nothing: that of Node 22. */
  readonly webSocket?: ServiceSocketConstructor | undefined;
}

export interface ServeOptions extends RunOptions {
  /** http://127.0.0.1:8080, if it says nothing. */
  readonly server?: string | undefined;
  /** Of an account of the role `process` with the group `own`; else that in `tokenFile`, else RACE_TOKEN, else data/processes.token. */
  readonly token?: string | undefined;
  readonly tokenFile?: string | undefined;
  /** Ends it. */
  readonly signal?: AbortSignal | undefined;
  /** Lines for the author of the services; console.error, if it says nothing. */
  readonly show?: Log | undefined;
}

type Services = Service | readonly Service[];

const show: Log = (line) => console.error(line);

function tokenOf({ token, tokenFile }: ServeOptions): string | undefined {
  const given = token ?? (tokenFile === undefined ? process.env["RACE_TOKEN"] : undefined);
  const file = tokenFile ?? (existsSync(kTokenFile) ? kTokenFile : undefined);
  const found = given ?? (file === undefined ? undefined : readFileSync(file, "utf8").trim());
  return found === undefined ? undefined : checkedToken(found);
}

function webSocketOf({ webSocket }: RunOptions): ServiceSocketConstructor {
  const known = webSocket ?? (globalThis as { readonly WebSocket?: unknown }).WebSocket;
  if (known === undefined) throw new TypeError("there is no WebSocket here: give one, such as that of the package `ws`, or use Node 22");
  return known as ServiceSocketConstructor;
}

const hostedOf = (services: Services, shown: Log): readonly Hosted[] => [services].flat().map((each: Service) => new Hosted(each, shown));

const serverOf = (options: ServeOptions, shown: Log): ServiceServer => ({
  origin: originOf(options.server ?? kServer),
  token: () => tokenOf(options),
  webSocket: webSocketOf(options),
  show: shown,
});

/**
 * Offers services until `signal` is aborted; connects again whenever that is needed. Rejects with a DeclarationError: a class is no
 * service; a RaceError: the server refuses them; another error: there is no such token, file or WebSocket.
 */
export async function serve(services: Services, options: ServeOptions = {}): Promise<void> {
  const shown = options.show ?? show;
  await keepConnected(hostedOf(services, shown), serverOf(options, shown), options.signal ?? new AbortController().signal);
}

/** Lines that say why the server refuses services, each at its service. */
function refusalLines(error: RaceError, hosted: readonly Hosted[]): readonly string[] {
  return error.errors.map(({ path, code, message }) => {
    const of = (hosted.find(({ declaration }) => declaration.key === path) ?? hosted[0])?.declaration;
    return of === undefined ? message : `${of.where()}: error: ${of.key}: ${code}: ${message}`;
  });
}

/** The exit status. */
async function statusOf(services: Services, options: ServeOptions): Promise<number> {
  let hosted: readonly Hosted[] = [];
  try {
    hosted = hostedOf(services, show);
    await keepConnected(hosted, serverOf(options, show), options.signal ?? new AbortController().signal);
    return 0;
  } catch (error) {
    for (const line of error instanceof RaceError ? refusalLines(error, hosted) : [messageOf(error)]) show(line);
    return 2;
  }
}

/** Offers services until SIGINT or SIGTERM, as the command line says, and ends the process: with 0, or 2 if they are refused. */
export async function run(services: Services, options: RunOptions = {}): Promise<never> {
  const ending = new AbortController();
  // Each: a second signal, as of a parent that gets Ctrl-C, too, would not let what moves be halted.
  for (const signal of ["SIGINT", "SIGTERM"] as const) process.on(signal, () => ending.abort());
  const words = commandLine();
  if (typeof words === "number") process.exit(words);
  if (words.reload) await runAnewWhenSaved(ending.signal, show);
  process.exit(words.reload ? 0 : await statusOf(services, { ...options, ...words, signal: ending.signal }));
}

/** What it says; or the exit status, if nothing is offered. */
function commandLine(): (Pick<ServeOptions, "server" | "tokenFile"> & { readonly reload: boolean }) | number {
  try {
    const { values } = parseArgs({ options: { server: { type: "string" }, "token-file": { type: "string" }, [kReload]: { type: "boolean" }, help: { type: "boolean", short: "h" } } });
    if (values.help !== true) return { server: values.server, tokenFile: values["token-file"], reload: values[kReload] === true };
    console.log(kUsage);
    return 0;
  } catch (error) {
    show(`${messageOf(error)}\n${kUsage}`);
    return 2;
  }
}
