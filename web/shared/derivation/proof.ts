// A derivation as a reader sees it: the judgement of each node, the values it holds, and which nodes are worth opening first.
import type { JsonValue } from "../json";
import type { Derivation, TraceStep } from "../../generated/messages";
import { clip, valueText } from "../model/describe";
import { literal } from "../model/literal";
import { nameOf } from "../model/modelTree";
import { counted } from "../counted";
import type { Subject } from "../run/subject";

/** Place of a node in its tree: the premise numbers from the root. */
export type ProofPath = readonly number[];

export function nodeAt(root: Derivation, path: ProofPath): Derivation | undefined {
  return path.reduce<Derivation | undefined>((node, i) => node?.premises[i], root);
}

/** What a node is about: the node, with its port, action or parameter. */
export function subjectText(node: Derivation): string {
  const subject = nameOf(node.at);
  if (node.parameter !== undefined) return `${subject}.par.${node.parameter}`;
  if (node.port?.includes("/") === true) return `${subject} by ${node.port}`;
  if (node.port !== undefined) return `${subject}.${node.port}`;
  if (node.action !== undefined) return `${subject}.actions[${node.action}]`;
  return node.of === undefined ? subject : `${subject}.${node.of}`;
}

/** A part of a node's row; `full` is the whole text where `text` is a short form. */
export interface RowPart {
  readonly kind: "rule" | "equation" | "subject" | "call" | "value" | "reads" | "refinement";
  readonly text: string;
  readonly full?: string;
}

/** All that a node holds but its premises, uncut: two nodes that differ read differently. */
export function rowParts(node: Derivation): readonly RowPart[] {
  const subject = subjectText(node);
  return [
    { kind: "rule", text: node.rule },
    { kind: "equation", text: `(${node.equation})` },
    { kind: "subject", text: subject, full: `${node.at}${subject.slice(nameOf(node.at).length)}` },
    ...(node.service === undefined ? [] : [{ kind: "call", text: serviceCall(node) } as const]),
    ...(node.value === undefined ? [] : [{ kind: "value", text: literal(node.value) } as const]),
    ...(node.requires === undefined ? [] : [{ kind: "reads", text: `reads ${node.requires.join(", ")}` } as const]),
    ...(node.refinement === undefined ? [] : [{ kind: "refinement", text: node.refinement } as const]),
  ];
}

function serviceCall(node: Derivation): string {
  const keywords = Object.entries(node.kwargs ?? {}).map(([name, value]) => `${name}=${literal(value)}`);
  return `${node.service ?? ""}.${node.operation ?? ""}(${[...(node.args ?? []).map(literal), ...keywords].join(", ")})`;
}

/** The judgement that a node concludes, in the symbols of the thesis. */
export function judgement(node: Derivation): string {
  const subject = subjectText(node);
  const value = node.value === undefined ? "…" : clip(valueText(node.value), 40);
  switch (node.rule) {
    case "Micro":
    case "PTrigger":
    case "PTrans1":
    case "PTrans2":
    case "SProp":
      return `Σ,Δ ⊢ ${nameOf(node.at)} → ${nameOf(node.at)}′, Δ′`;
    case "SAct1":
    case "SAct2":
    case "BAct1":
    case "BAct2":
    case "BAct3":
      return `Σ,Δ ⊢ ${nameOf(node.at)} →↑ ${nameOf(node.at)}′, Δ′`;
    case "SDeact1":
    case "SDeact2":
    case "BDeact":
      return `Σ,Δ ⊢ ${nameOf(node.at)} →↓ ${nameOf(node.at)}′, Δ′`;
    case "Active":
      return `Δ ⊢ ${nameOf(node.at)}.active ⇝ ${value}`;
    case "Act":
      return `Δ ⊢ ${subject} ⇝ ${subject}[active = true], Δ′`;
    case "Deact":
      return `Δ ⊢ ${subject} ⇝ ${subject}[active = false], Δ′`;
    case "Cond":
    case "CondBE":
    case "CondBD":
      return `Σ,Δ ⊢ ${subject}.cond ⇝ ${value}`;
    case "Resolve":
      return `Δ ⊢ ${subject} ⇝ ${value}, Δ′`;
    case "FuncSC":
      return `${node.service ?? ""}.${node.operation ?? ""}(${(node.args ?? []).map((arg) => clip(valueText(arg), 24)).join(", ")}) is called`;
    case "Activated":
    case "BIn":
      return `Δ ⊢ ${nameOf(node.at)} ∋ ${node.port ?? ""}${node.value === undefined ? "" : ` ⇝ ${value}`}`;
    default:
      return `Σ,Δ ⊢ ${subject} ⇝ ${subject}′, Δ′`;
  }
}

/** All that a node holds but its premises, as name and text, uncut. */
export function facts(node: Derivation): readonly { readonly name: string; readonly text: string }[] {
  const fact = (name: string, value: JsonValue | undefined) => (value === undefined ? [] : [{ name, text: literal(value) }]);
  const name = (name: string, text: string | undefined) => (text === undefined ? [] : [{ name, text }]);
  return [
    { name: "at", text: node.at },
    ...name("port", node.port),
    ...fact("action", node.action),
    ...name("parameter", node.parameter),
    ...name("of", node.of),
    ...name("calls", node.service === undefined ? undefined : `${node.service}.${node.operation ?? ""}`),
    ...fact("value", node.value),
    ...(node.requires === undefined ? [] : [{ name: "reads", text: node.requires.join(", ") }]),
    ...fact("args", node.args),
    ...(node.kwargs === undefined || Object.keys(node.kwargs).length === 0 ? [] : fact("kwargs", node.kwargs)),
    ...name("refinement", node.refinement),
  ];
}

const kQuiet: ReadonlySet<string> = new Set(["Active", "Act", "Deact", "Cond", "CondBE", "CondBD", "SDeact1", "Action2", "Action3"]);

/** Whether something notable happens in this subtree: then it is unfolded at first. */
export function notable(node: Derivation): boolean {
  if (kQuiet.has(node.rule)) return false;
  return node.rule !== "SProp" && node.rule !== "Micro" ? true : node.premises.some(notable);
}

/** What a micro step did, in a few words: the ports that fired, the nodes that were entered, the calls. */
export function summary(root: Derivation): string {
  const found: string[] = [];
  const visit = (node: Derivation) => {
    if (node.rule === "PTrigger") found.push(`${nameOf(node.at)}.${node.port ?? ""} fires`);
    if (node.rule === "SAct1" || node.rule === "BAct1" || node.rule === "BAct2") found.push(`${nameOf(node.at)} entered`);
    if (node.rule === "FuncSC") found.push(`calls ${node.service ?? ""}.${node.operation ?? ""}`);
    if (node.rule === "Action1") found.push(`${nameOf(node.at)} action ${(node.action ?? 0) + 1}`);
    node.premises.forEach(visit);
  };
  visit(root);
  return found.length === 0 ? "nothing new" : found.join(" · ");
}

/** The first inference at which something notable happens; the rules above it only lead there. */
export function leading(root: Derivation): ProofPath {
  if (root.rule !== "Micro" && root.rule !== "SProp") return [];
  const next = root.premises.findIndex(notable);
  const premise = root.premises[next];
  return premise === undefined ? [] : [next, ...leading(premise)];
}

/** A micro step of a run: the macro step, counted from 1, and how many micro steps of it come before, as the server asks. */
export interface MicroStep {
  readonly step: number;
  readonly micro: number;
}

export const isLater = (a: MicroStep, b: MicroStep): boolean => a.step > b.step || (a.step === b.step && a.micro > b.micro);

/** Its number as people read it, from 1, so that moment 3.2 is the one after micro step 2. */
export const microNumber = (before: number): number => before + 1;

export const microStepText = ({ step, micro }: MicroStep): string => `macro step ${step}, micro step ${microNumber(micro)}`;

/** Whether by this inference the port fires (PTrigger), the action is executed (Action1), or the parameter gets its value (Resolve). */
function isOf({ rule, at, port, action, parameter }: Derivation, subject: Subject): boolean {
  if ("port" in subject) return rule === "PTrigger" && `${at}.${port ?? ""}` === subject.port;
  if ("action" in subject) return rule === "Action1" && at === subject.state && action === subject.action;
  return rule === "Resolve" && at === subject.state && parameter === subject.parameter;
}

/** The inference of the subject, or undefined if there is none. */
export function inferenceOf(root: Derivation, subject: Subject): ProofPath | undefined {
  if (isOf(root, subject)) return [];
  for (const [i, premise] of root.premises.entries()) {
    const path = inferenceOf(premise, subject);
    if (path !== undefined) return [i, ...path];
  }
  return undefined;
}

/** The latest of these micro steps with an inference of the subject. */
export function lastInference(steps: readonly TraceStep[], subject: Subject): MicroStep | undefined {
  const has = (root: Derivation): boolean => inferenceOf(root, subject) !== undefined;
  const step = [...steps].reverse().find((each) => each.micro.some(has));
  return step === undefined ? undefined : { step: step.step, micro: (step.first ?? 0) + step.micro.map(has).lastIndexOf(true) };
}

/** Of these steps, what was done before micro step `micro` of a macro step. */
export function stepsBefore(steps: readonly TraceStep[], { step, micro }: MicroStep): readonly TraceStep[] {
  return steps.flatMap((each) => {
    if (each.step !== step) return each.step < step ? [each] : [];
    return [{ ...each, micro: each.micro.slice(0, Math.max(0, micro - (each.first ?? 0))) }];
  });
}

export function premiseCount(node: Derivation): string {
  return counted(node.premises.length, "premise");
}

export function size(node: Derivation): number {
  return node.premises.reduce((sum, premise) => sum + size(premise), 1);
}
