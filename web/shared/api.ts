// The REST door: every request to the server, each answer parsed from `unknown` before anyone sees it.
import type { MicroStep } from "./derivation/proof";
import { array, boolean, number, object, present, record, string, type Decoder, type JsonValue } from "./json/decode";
import { scene, type Scene } from "./messages/cell";
import { core, type Core } from "./messages/core";
import { person, type Person, type PersonCommand } from "./messages/person";
import { rules, traceSteps, type RuleText, type TraceStep } from "./messages/derivation";
import { serverErrors, type ServerError } from "./messages/stream";
import { why, type Why } from "./messages/why";
import { rcmDocument } from "./model/decodeModel";
import type { RcmDocument } from "./model/model";
import { withOracles } from "./model/oracles";

export interface DocumentEntry {
  readonly name: string;
  readonly revision: number;
  readonly doc?: string;
}

/** What the server hosts; `cell`: it has a simulated cell. */
export interface Health {
  readonly version: string;
  readonly cell: boolean;
}

/** How far a paused core goes. */
export type Step =
  | { readonly kind: "micro" }
  | { readonly kind: "macro" }
  | { readonly kind: "until"; readonly path: string; readonly when: "entered" | "left" };

/** The server refused a request: its errors, as it gave them. */
export class RefusedError extends Error {
  constructor(
    readonly status: number,
    readonly errors: readonly ServerError[],
  ) {
    super(errors.map((error) => (error.path === "" ? error.message : `${error.path}: ${error.message}`)).join("; "));
    this.name = "RefusedError";
  }
}

const documents: Decoder<readonly DocumentEntry[]> = object((f) =>
  f.need(
    "documents",
    array(
      object((d) =>
        present<DocumentEntry>({ name: d.need("name", string), revision: d.need("revision", number), doc: d.maybe("doc", string) }),
      ),
    ),
  ),
);

const health: Decoder<Health> = object((f) => ({ version: f.need("version", string), cell: f.need("cell", boolean) }));

const native: Decoder<RcmDocument> = object((f) => {
  const document = f.need("document", rcmDocument);
  return { ...document, root: withOracles(document.root, f.need("origin", record(string))) };
});

const segment = encodeURIComponent;

/** Requests below `base` (`/api/v1`); `fetcher` is the browser's fetch, or a test's. */
export function createApi(base: string, fetcher: typeof fetch) {
  async function request<T>(method: string, path: string, decoder: Decoder<T>, body?: JsonValue): Promise<T> {
    const init: RequestInit = body === undefined ? { method } : { method, body: JSON.stringify(body), headers: { "content-type": "application/json" } };
    const answer = await fetcher(`${base}${path}`, init);
    const data: unknown = await answer.json();
    if (!answer.ok) throw new RefusedError(answer.status, serverErrors(data, ""));
    return decoder(data, "");
  }
  const get = <T>(path: string, decoder: Decoder<T>) => request("GET", path, decoder);
  const command = (id: string, name: string) => request("POST", `/cores/${segment(id)}/${name}`, core);
  return {
    health: (): Promise<Health> => get("/health", health),
    rules: (): Promise<readonly RuleText[]> => get("/rules", rules),
    documents: (): Promise<readonly DocumentEntry[]> => get("/documents", documents),
    createCore: (document: string, args: Readonly<Record<string, JsonValue>>): Promise<Core> =>
      request("POST", "/cores", core, { document, arguments: args }),
    coreModel: (id: string): Promise<RcmDocument> => get(`/cores/${segment(id)}/native`, native),
    start: (id: string): Promise<Core> => command(id, "start"),
    pause: (id: string): Promise<Core> => command(id, "pause"),
    resume: (id: string): Promise<Core> => command(id, "resume"),
    stop: (id: string): Promise<Core> => command(id, "stop"),
    step: (id: string, step: Step): Promise<Core> => request("POST", `/cores/${segment(id)}/step`, core, { ...step }),
    derivations: (id: string, from: number, to: number): Promise<readonly TraceStep[]> =>
      get(`/cores/${segment(id)}/derivations?from=${from}&to=${to}`, traceSteps),
    /** As things are now, or as they were before a past micro step. */
    why: (id: string, port: string, before?: MicroStep): Promise<Why> =>
      get(`/cores/${segment(id)}/why?port=${segment(port)}${before === undefined ? "" : `&step=${before.step}&micro=${before.micro}`}`, why),
    cell: (): Promise<Scene> => get("/cell", scene),
    person: (): Promise<Person> => get("/cell/person", person),
    act: (act: PersonCommand): Promise<Person> => request("POST", "/cell/person", person, { ...act }),
    /** Address of a file that the scene names. */
    cellFile: (file: string): string => `${base}/cell/${segment(file)}`,
  };
}

export type Api = ReturnType<typeof createApi>;
