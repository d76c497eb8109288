// What a service offers: its operations, its RSM, which is made of them or given, and where each of these stands in a file.
import { readFileSync } from "node:fs";
import { dirname, resolve } from "node:path";
import { isObject, type JsonObject, type JsonValue } from "../json.js";
import { generatedRsm } from "./generatedRsm.js";
import { Operation } from "./operation.js";
import { placeOf, placeText, sourceOf, type Source } from "./place.js";
import { readRsm, type Rsm } from "./rsm.js";
import { kPlace, type Service } from "./service.js";
import { checkedValue, messageOf } from "./values.js";

/** A class is no service; the message begins with FILE:LINE. */
export class DeclarationError extends Error {
  constructor(where: string, message: string) {
    super(`${where}: error: ${message}`);
    this.name = "DeclarationError";
  }
}

/** Fields of a service that are operations, in their order. */
function operationsOf(service: Service): ReadonlyMap<string, Operation> {
  const fields = Object.entries(service) as readonly (readonly [string, unknown])[];
  return new Map(fields.flatMap(([name, value]) => (value instanceof Operation ? [[name, value] as const] : [])));
}

/** A file of an RSM. Throws a DeclarationError: there is none, or it has an error of syntax. */
function readFile(file: string): { readonly value: JsonValue; readonly source: Source } {
  let text = "";
  try {
    text = readFileSync(file, "utf8");
    return { value: JSON.parse(text) as JsonValue, source: { file, first: 1, lines: text.split("\n") } };
  } catch (error) {
    const message = messageOf(error);
    const [, position = "0"] = /position (\d+)/.exec(message) ?? [];
    throw new DeclarationError(placeText({ file, line: text.slice(0, Number(position)).split("\n").length }), message);
  }
}

/** One service. Throws a DeclarationError: its class is none. */
export class Declaration {
  readonly key: string;
  readonly type: string;
  readonly operations: ReadonlyMap<string, Operation>;
  /** As the server gets it. */
  readonly rsm: JsonObject;
  readonly model: Rsm;
  private readonly source: Source;
  private rsmSource: Source | undefined;

  constructor(service: Service) {
    this.operations = operationsOf(service);
    const [first] = this.operations.values();
    this.source = sourceOf(service, first?.place ?? service[kPlace]);
    this.key = this.name(service, "key");
    this.type = this.name(service, "type", this.key);
    this.rsm = this.rsmOf(service);
    this.model = this.modelOf(this.rsm);
    for (const { name } of this.model.operations) {
      if (!this.operations.has(name)) throw this.error(`the RSM has the operation \`${name}\`, and ${service.constructor.name} has none of this name`, name);
    }
  }

  /** FILE:LINE where the first of these names is declared that is; else that of the class. */
  where(...names: readonly string[]): string {
    for (const name of names) {
      const inRsm = this.rsmSource === undefined ? undefined : placeOf(name, this.rsmSource);
      const found = inRsm ?? this.operations.get(name)?.place ?? placeOf(name, this.source);
      if (found !== undefined) return placeText(found);
    }
    return placeText({ file: this.source.file, line: this.source.first });
  }

  /** FILE:LINE of what a message `violation` (api/schemas/component_message.json) is about. */
  whereViolated({ operation, message }: { readonly operation: string; readonly message: string }): string {
    return this.where(operation, ...[...message.matchAll(/`(\w+)`/g)].map(([, name = ""]) => name));
  }

  /** An error at the place where one of these names is declared. */
  private error(message: string, ...names: readonly string[]): DeclarationError {
    return new DeclarationError(this.where(...names), message);
  }

  private name(service: Service, field: "key" | "type", otherwise?: string): string {
    const value: unknown = service[field] ?? otherwise;
    if (typeof value === "string" && /^[A-Za-z_]\w{0,63}$/.test(value)) return value;
    throw this.error(`${service.constructor.name} needs a \`${field}\` of letters, digits and \`_\`, at most 64`);
  }

  private rsmOf({ rsm, events = {}, version }: Service): JsonObject {
    if (rsm === undefined) {
      const made = generatedRsm(this.key, this.declared(), events);
      return version === undefined ? made : { ...made, meta: { version } };
    }
    const { value, source } = typeof rsm === "string" ? readFile(resolve(dirname(this.source.file), rsm)) : { value: rsm, source: undefined };
    this.rsmSource = source;
    if (isObject(value)) return value;
    throw this.error("an RSM is an object");
  }

  private declared() {
    const listed = [...this.operations].map(([name, each]) => ({ model: each.model(name), busy: each.options.busy, stops: each.options.stops }));
    for (const { model, stops } of listed) {
      if (stops !== undefined && !listed.some(({ busy }) => busy === stops)) throw this.error(`\`${model.name}\` stops \`${stops}\`, in which nothing is busy`, model.name);
    }
    return listed;
  }

  private modelOf(rsm: JsonObject): Rsm {
    try {
      checkedValue(rsm);
      return readRsm(rsm);
    } catch (error) {
      throw this.error(messageOf(error));
    }
  }
}
