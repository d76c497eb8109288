// A change in words, and as a text to be kept: so that what was refused can be seen, copied and made again.
import { valueText } from "../model/describe";
import { isObject, type JsonValue } from "../json";
import type { Operation } from "./apply";
import { writeLines, type ExactObject } from "./clipboard/json";
import type { SetPlace } from "./conflicts";
import { elementText } from "./difference/rows";
import { plain, type Exact, type ExactJson } from "./exact";
import type { Change } from "./session";
import type { Tree } from "./tree";

const kMost = 3;
const kLongest = 80;
const clipped = (text: string): string => (text.length > kLongest ? `${text.slice(0, kLongest - 1)}…` : text);

const named = (tree: Tree, id: string): string => (id === "" ? "the document" : tree.elements.has(id) ? elementText(tree, id) : "what is gone");

/** Texts in quotes, other values as a task author would write them. */
export const shownValue = (value: JsonValue | undefined): string => (value === undefined ? "nothing" : typeof value === "string" ? `“${clipped(value)}”` : clipped(valueText(value)));

/** A field of an element, or an entry of one. */
export const placeText = (tree: Tree, { id, field, key }: SetPlace): string => `${field}${key === undefined ? "" : ` ${key}`} of ${named(tree, id)}`;

/** A message of the server, which quotes ids, with what they stand for. */
export const withNames = (tree: Tree, message: string): string => message.replace(/`([A-Za-z0-9_-]{1,64})`/g, (quoted, id: string) => (tree.elements.has(id) ? named(tree, id) : quoted));

const nameOfNode = (node: JsonValue): string => {
  if (!isObject(node)) return "";
  const name = node["state"] ?? node["barrier"] ?? node["name"];
  return typeof name === "string" ? ` ${name}` : "";
};

function operationText(tree: Tree, operation: Operation): string {
  switch (operation.op) {
    case "insert":
      return `new${nameOfNode(operation.node as JsonValue)} in ${named(tree, operation.parent)}`;
    case "remove":
      return `delete ${named(tree, operation.id)}`;
    case "move":
      return `move ${named(tree, operation.id)}`;
    case "set":
      return `${placeText(tree, operation)}: ${shownValue(operation.value)}`;
  }
}

/** What it was to do; nothing of undo and redo, whose edits are the server's. */
export function changeText(tree: Tree, change: Change): string | undefined {
  if ("compound" in change) {
    const { compound } = change;
    const name = "name" in compound ? ` to ${compound.name}` : "";
    return "id" in compound ? `${named(tree, compound.id)}${name}` : undefined;
  }
  if (!("operations" in change)) return undefined;
  const texts = plain<readonly Operation[]>(change.operations).map((operation) => operationText(tree, operation));
  return `${texts.slice(0, kMost).join("; ")}${texts.length > kMost ? `; and ${texts.length - kMost} more` : ""}`;
}

/** What it would have written, as a text for the clipboard: a text that was typed, or elements that can be pasted; nothing: neither. */
export function writtenText(change: Change): string | undefined {
  if ("compound" in change) return "name" in change.compound ? change.compound.name : undefined;
  if (!("operations" in change)) return undefined;
  const operations: readonly Exact<Operation>[] = change.operations;
  const nodes = operations.flatMap((operation) => (operation.op === "insert" ? [operation] : []));
  const ofList = (list: string) => nodes.filter((node) => node.list === list).map(({ node }) => node as ExactJson);
  const [children, ports] = [ofList("children"), ofList("ports")];
  const pasted: ExactObject = { ...(children.length > 0 && { children }), ...(ports.length > 0 && { ports }) };
  if (Object.keys(pasted).length > 0) return `${writeLines(pasted)}\n`;
  const values = operations.flatMap((operation) => (operation.op === "set" && operation.value !== undefined ? [operation.value] : []));
  return values.length === 0 ? undefined : values.map((value) => (typeof value === "string" ? value : writeLines(value))).join("\n");
}
