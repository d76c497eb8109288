// Where the order of declaration may decide what a task does (core/SEMANTICS.md, section 4): ports of which two may be fulfilled in the same
// micro step, actions that meet in a value or a service, children that are active at the same time. It may say so of too many, not of too few.
import type { Action, Port, State } from "../model/model";

/** The numbers of those in a list of which another one's place matters. */
export type Conflicts = ReadonlySet<number>;

const kLiteral = /(["'])(?:\\.|(?!\1).)*\1/g;
const kComparison = /^([\w.]+)\s*==\s*("[^"\\]*"|'[^'"\\]*'|-?\d+|True|False)$/;
const kNegation = /^not\s+([\w.]+)$/;

function add<K>(counts: Map<K, number>, key: K): void {
  counts.set(key, (counts.get(key) ?? 0) + 1);
}

/** Only literals of one kind are compared here: 1 is True. */
const kindOf = (literal: string): string => (/\d$/.test(literal) ? "int" : /^[TF]/.test(literal) ? "bool" : "string");

/** What a condition says in full, as far as it excludes others by that: `X == literal`, `X`, or `not X`. */
function claimOf(condition: string): { readonly about: string; readonly is: string } | undefined {
  const text = condition.trim();
  const [, about, value] = kComparison.exec(text) ?? [];
  if (about !== undefined && value !== undefined) return { about: `${about} == ${kindOf(value)}`, is: /\d$/.test(value) ? String(BigInt(value)) : value.replace(/^'(.*)'$/, '"$1"') };
  const [, denied] = kNegation.exec(text) ?? [];
  if (denied !== undefined) return { about: denied, is: "False" };
  return /^[\w.]+$/.test(text) ? { about: text, is: "True" } : undefined;
}

/** Ports that may fire in the same micro step as another one, so that the first of them does. Those of a linking state stand in the library's order. */
export function portConflicts(ports: readonly Port[], isLinking = false): Conflicts {
  if (isLinking) return new Set();
  const live = ports.map((port, i) => ({ i, condition: port.after ?? port.when, claim: port.after === undefined ? claimOf(port.when) : undefined })).filter(({ condition }) => condition.trim() !== "False");
  const about = new Map<string, number>();
  const same = new Map<string, number>();
  for (const { claim } of live) {
    if (claim === undefined) continue;
    add(about, claim.about);
    add(same, `${claim.about} ${claim.is}`);
  }
  // Of the others, these exclude it: they say something else about the same.
  const excluded = (claim: ReturnType<typeof claimOf>) => (claim === undefined ? 0 : (about.get(claim.about) ?? 0) - (same.get(`${claim.about} ${claim.is}`) ?? 0));
  return new Set(live.filter(({ claim }) => excluded(claim) < live.length - 1).map(({ i }) => i));
}

const kUse = /\b(res|var)\.([A-Za-z_]\w*)(?:\[[^\]]*\]|\.\w+)*(\s*(?:[-+*/%]|\*\*|\/\/)?=(?!=))?/g;
const kUnpacked = /^\s*(?:for\s+)?([^=\n]*,[^=\n]*?)(?:\s=[^=]|\sin\s)/gm;
const kService = /\bsvc(?:\.([A-Za-z_]\w*)|\[)/g;

/** What a text uses: values (and whether it writes them), and services. `svc[...]` may be any of them. */
function usesOf({ when, do: code }: Action): { readonly used: ReadonlySet<string>; readonly written: ReadonlySet<string>; readonly services: ReadonlySet<string> } {
  const [condition, plain] = [when.replace(kLiteral, "''"), code.replace(kLiteral, "''")];
  const used = new Set<string>();
  const written = new Set<string>();
  for (const [, scope, name, assigned] of `${condition}\n${plain}`.matchAll(kUse)) {
    const value = `${scope ?? ""}.${name ?? ""}`;
    used.add(value);
    if (assigned !== undefined) written.add(value);
  }
  for (const [, targets] of plain.matchAll(kUnpacked)) for (const [, scope, name] of (targets ?? "").matchAll(kUse)) written.add(`${scope ?? ""}.${name ?? ""}`);
  const services = new Set([...plain.matchAll(kService)].map(([, name]) => name ?? "*"));
  return { used, written, services };
}

/** Actions that write what another one uses, or use what another one writes, or that both turn to the same service. */
export function actionConflicts(actions: readonly Action[]): Conflicts {
  const all = actions.map(usesOf);
  const [using, writing, turning] = [new Map<string, number>(), new Map<string, number>(), new Map<string, number>()];
  for (const { used, written, services } of all) {
    used.forEach((value) => add(using, value));
    written.forEach((value) => add(writing, value));
    services.forEach((service) => add(turning, service));
  }
  const withServices = all.filter(({ services }) => services.size > 0).length;
  const anyService = turning.get("*") ?? 0;
  return new Set(
    all.flatMap(({ used, written, services }, i) => {
      const byValue = [...used].some((value) => (written.has(value) ? (using.get(value) ?? 0) > 1 : (writing.get(value) ?? 0) > 0));
      const byService = services.has("*") ? withServices > 1 : services.size > 0 && (anyService > 0 || [...services].some((service) => (turning.get(service) ?? 0) > 1));
      return byValue || byService ? [i] : [];
    }),
  );
}

/** Children that may be active together: what a barrier with several targets leads to, up to the barrier at which as many come together. */
export function childConflicts({ children }: State): Conflicts {
  const numbers = new Map(children.map((child, i) => [child.name, i]));
  const inbound = new Map<string, number>();
  for (const child of children) if (child.kind === "state") for (const { to } of child.ports) if (to !== undefined) add(inbound, to);
  const forks = children
    .flatMap((child) => (child.kind === "barrier" ? [[...new Set(child.to)].filter((name) => numbers.has(name))] : []))
    .filter((targets) => targets.length > 1)
    .sort((a, b) => b.length - a.length);
  const seen = new Set<number>();
  // The widest first: it reaches all that a narrower one would, so each child is visited once.
  for (const targets of forks) {
    const open = targets.flatMap((name) => numbers.get(name) ?? []);
    for (let i = open.pop(); i !== undefined; i = open.pop()) {
      const child = children[i];
      if (child === undefined || seen.has(i)) continue;
      if (child.kind === "barrier" && (inbound.get(child.name) ?? 0) >= targets.length) continue;
      seen.add(i);
      const next = child.kind === "barrier" ? child.to : child.ports.flatMap(({ to }) => to ?? []);
      open.push(...next.flatMap((name) => numbers.get(name) ?? []));
    }
  }
  return new Set([...seen].filter((i) => children[i]?.kind === "state"));
}
