// Names that code may use, with what is known of them; a name's members are found when they are asked for.
import type { Type } from "../../generated/messages";
import { isObject, type JsonValue } from "../json";

export type NameKind =
  | "collection" | "parameter" | "result" | "variable" | "port" | "child" | "active" | "service" | "operation" | "event" | "answer" | "function" | "module" | "constant" | "field" | "method" | "argument" | "local" | "keyword";

export interface Name {
  readonly name: string;
  readonly kind: NameKind;
  readonly type?: Type;
  readonly unit?: string;
  readonly doc?: string;
  /** Of a function, method or operation: its parameters, as a call has them. */
  readonly call?: string;
  /** Of an operation: what may be given by its name. */
  readonly parameters?: readonly Name[];
  /** What else there is to know, in a line. */
  readonly note?: string;
  /** What may stand behind `name.`; nothing: unknown. */
  readonly members?: () => readonly Name[];
  /** There may be others than `members`. */
  readonly isOpen?: true;
}

/** A TYPE in words: `list of 6 number`. */
export function typeText(type: Type): string {
  if (typeof type === "string") return type;
  if ("list" in type) return `list of ${type.size === undefined ? "" : `${type.size} `}${typeText(type.list)}`;
  if ("optional" in type) return `${typeText(type.optional)} or None`;
  if ("enum" in type) return type.enum.map((value) => JSON.stringify(value)).join(" | ");
  return `{${Object.entries(type.record).map(([name, of]) => `${name}: ${typeText(of)}`).join(", ")}}`;
}

const kPose: Type = { record: { position: { list: "number", size: 3 }, orientation: { list: "number", size: 4 } } };
const kImage: Type = { record: { width: "int", height: "int" } };

/** The fields of a value of this type; nothing, if it has none that are known. */
function fieldsOfType(type: Type | undefined): (() => readonly Name[]) | undefined {
  if (type === "pose") return fieldsOfType(kPose);
  if (type === "image") return fieldsOfType(kImage);
  if (type === undefined || typeof type === "string") return undefined;
  if ("optional" in type) return fieldsOfType(type.optional);
  if (!("record" in type)) return undefined;
  const { record } = type;
  return () => Object.entries(record).map(([name, of]) => valueName(name, "field", { type: of }));
}

interface About {
  readonly type?: Type | undefined;
  readonly unit?: string | undefined;
  readonly doc?: string | undefined;
}

/** The name of a value, with the fields that its type has. */
export function valueName(name: string, kind: NameKind, { type, unit, doc }: About): Name {
  const members = fieldsOfType(type);
  return {
    name, kind, isOpen: true,
    ...(type !== undefined && { type }), ...(unit !== undefined && unit !== "" && { unit }), ...(doc !== undefined && doc !== "" && { doc }), ...(members !== undefined && { members }),
  };
}

const kSimple: ReadonlySet<JsonValue> = new Set(["any", "null", "bool", "int", "number", "string", "pose", "image"]);

/** A TYPE that a document has; one that is none says nothing. */
export function readType(value: JsonValue | undefined): Type | undefined {
  // The documents that pages edit have been read with their format (edit/fields.ts), so that an object here is a TYPE.
  return value !== undefined && (kSimple.has(value) || isObject(value)) ? (value as Type) : undefined;
}
