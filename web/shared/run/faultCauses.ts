// What led to a fault: where in the code of its state it can have happened, and the ports by which that state was entered.
import type { Fault, TraceStep } from "../../generated/messages";
import { isLater, lastInference } from "../derivation/proof";
import { codeText, parameterText, portText } from "../model/describe";
import { portAddress } from "../model/model";
import type { Selection } from "../model/identity";
import { ancestry, inboundPorts, stateAt, type ModelTree } from "../model/modelTree";
import { causes, type Cause } from "./causes";

/** A part of the code of a state. */
export interface CodePlace {
  readonly part: "parameter" | "entry" | "exit" | "action" | "port";
  readonly text: string;
  readonly selection: Selection;
}

/** What a text must have for the fault to be in it. */
const kSigns: Partial<Readonly<Record<Fault["kind"], RegExp>>> = { zero_division: /[/%]/ };

/** Where in the state of the fault it can have happened: while it is entered, its parameters and entry are evaluated, else the rest. */
export function faultPlaces(tree: ModelTree, { at, kind }: Fault, isActive: boolean): readonly CodePlace[] {
  const state = stateAt(tree, at);
  if (state === undefined) return [];
  const sign = kSigns[kind];
  /** The first line that it can be in. */
  const lineOf = (code: string): string => codeText(code.split("\n").filter((line) => sign?.test(line) === true).join("\n") || code);
  const node: Selection = { kind: "node", path: at };
  const functionOf = (part: "entry" | "exit", code: string | undefined): readonly (CodePlace & { readonly code: string })[] =>
    code === undefined ? [] : [{ part, text: lineOf(code), selection: node, code }];
  const entered = [
    ...state.parameters.filter(({ from }) => from !== undefined).map((each) => ({ part: "parameter" as const, text: parameterText(each), selection: node, code: each.from ?? "" })),
    ...functionOf("entry", state.entry),
  ];
  const later = [
    ...state.actions.map((each) => ({ part: "action" as const, text: `[${each.when}] ${lineOf(each.do)}`, selection: node, code: `${each.when}\n${each.do}` })),
    ...state.ports.map((each) => ({ part: "port" as const, text: portText(each), selection: { kind: "port", address: portAddress(at, each) } as const, code: each.when ?? each.after })),
    ...functionOf("exit", state.exit),
  ];
  const evaluated = isActive ? later : entered;
  const fitting = sign === undefined ? evaluated : evaluated.filter(({ code }) => sign.test(code));
  return (fitting.length > 0 ? fitting : evaluated).map(({ part, text, selection }) => ({ part, text, selection }));
}

/** The ports that lead to a node, also through barriers. */
function leadingTo(tree: ModelTree, path: string): readonly string[] {
  const entry = tree.get(path);
  const siblings = entry?.parent === undefined ? [] : (tree.get(entry.parent)?.children ?? []);
  const barriers = siblings.filter(({ node }) => node.kind === "barrier" && entry !== undefined && node.to.includes(entry.node.name));
  return [path, ...barriers.map((each) => each.path)].flatMap((each) => inboundPorts(tree, each));
}

/** The chain from the port by which the state of a fault, or one around it, was entered last, as far as the derivations are among `steps`. */
export function faultCauses(tree: ModelTree, steps: readonly TraceStep[], at: string): readonly Cause[] {
  const fired = ancestry(at)
    .flatMap((path) => leadingTo(tree, path))
    .flatMap((address) => {
      const firing = lastInference(steps, { port: address });
      return firing === undefined ? [] : [{ address, firing }];
    });
  const [last] = fired.sort((a, b) => (isLater(a.firing, b.firing) ? -1 : 1));
  return last === undefined ? [] : causes(tree, steps, last.address);
}
