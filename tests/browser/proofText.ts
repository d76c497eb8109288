// Derivations as text, one line for each node, premises indented beneath: once from the JSON of `race derive`, once from what the page shows.
// The two share one function of the page, `literal` (tested by web/tests/model/literal.test.ts); all else is written here independently.
import type { Locator, Page } from "playwright-core";
import type { JsonValue } from "../../web/shared/json";
import { kRow } from "../../web/pro/derivation/row";
import { literal } from "../../web/shared/model/literal";

/** A node as `race derive` prints it: not checked, so that fields that the page ignores are kept. */
export interface RawNode {
  readonly rule: string;
  readonly equation: string;
  readonly at: string;
  readonly premises: readonly RawNode[];
  readonly port?: string;
  readonly action?: number;
  readonly parameter?: string;
  readonly of?: string;
  readonly value?: JsonValue;
  readonly requires?: readonly string[];
  readonly refinement?: string;
  readonly service?: string;
  readonly operation?: string;
  readonly args?: readonly JsonValue[];
  readonly kwargs?: Readonly<Record<string, JsonValue>>;
}

export interface RawStep {
  readonly micro: readonly RawNode[];
}

/** The suffix of a node's path: its port, parameter, action or function; for the target of a transition, the port that leads there. */
function suffix({ port, parameter, action, of }: RawNode): string {
  if (parameter !== undefined) return `.par.${parameter}`;
  if (port !== undefined) return port.includes("/") ? ` by ${port}` : `.${port}`;
  if (action !== undefined) return `.actions[${action}]`;
  return of === undefined ? "" : `.${of}`;
}

function callOf({ service, operation, args, kwargs }: RawNode): string | undefined {
  if (service === undefined) return undefined;
  const texts = [...(args ?? []).map(literal), ...Object.entries(kwargs ?? {}).map(([name, value]) => `${name}=${literal(value)}`)];
  return `${service}.${operation ?? "?"}(${texts.join(", ")})`;
}

/** A line for each node, in pre-order. A field that this function does not know is an error. */
export function expectedLines(node: RawNode, depth = 0): readonly string[] {
  const { rule, equation, at, premises, port: _p, action: _a, parameter: _q, of: _o, service: _s, operation: _n, args: _r, kwargs: _k, ...rest } = node;
  const { value, requires, refinement, ...unknown } = rest;
  if (Object.keys(unknown).length > 0) throw new Error(`${rule} at ${at} has fields that the page does not show: ${Object.keys(unknown).join(", ")}`);
  const subject = `${at.split("/").at(-1) ?? ""}${suffix(node)}`;
  const parts = [
    rule,
    `(${equation})`,
    `${subject} <${at}${suffix(node)}>`,
    callOf(node),
    value === undefined ? undefined : literal(value),
    requires === undefined ? undefined : `reads ${requires.join(", ")}`,
    refinement,
  ];
  return [`${"  ".repeat(depth)}${parts.filter((part) => part !== undefined).join(" | ")}`, ...premises.flatMap((premise) => expectedLines(premise, depth + 1))];
}

/** Shows the derivation of the macro step in this row of the list, from 0. */
export async function showStep(page: Page, row: number): Promise<void> {
  const step = page.getByRole("list", { name: "Macro steps" }).getByRole("button").nth(row);
  await step.click();
  await page.waitForFunction((element) => element?.getAttribute("aria-current") === "step", await step.elementHandle());
}

/** The first element with this role and name among the proofs, in view: of a long list the page draws what is seen. */
async function reach(page: Page, role: "article" | "treeitem", name: RegExp): Promise<Locator> {
  const found = page.locator(".proofs").getByRole(role, { name }).first();
  const scroller = page.locator(".proofs");
  const { height, view } = await scroller.evaluate((element) => ({ height: element.scrollHeight, view: element.clientHeight }));
  for (let y = 0; (await found.count()) === 0; y += view) {
    if (y > height) throw new Error(`no ${role} ${String(name)} among the proofs`);
    await scroller.evaluate(async (element, top) => {
      element.scrollTop = top;
      await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    }, y);
  }
  return found;
}

/** The proof of a micro step, from 0. */
export const reachProof = (page: Page, micro: number): Promise<Locator> => reach(page, "article", new RegExp(`^Micro step ${micro + 1}$`));
export const reachNode = (page: Page, name: RegExp): Promise<Locator> => reach(page, "treeitem", name);

/** How many proofs the macro step has that is shown. */
export async function proofCount(page: Page): Promise<number> {
  const first = page.getByRole("article").first();
  return (await first.count()) === 0 ? 0 : Number(await first.getAttribute("aria-setsize"));
}

/** The same lines, read row by row from an unfolded proof: their visible text, and in <> the title of a subject, which names its whole path. */
export function shownLines(proof: Locator): Promise<readonly string[]> {
  return proof.evaluate(async (article) => {
    const scroller = article.closest(".proofs");
    if (scroller === null || !(article instanceof HTMLElement)) throw new Error("no proof");
    const lines = new Map<number, string>();
    const last = article.offsetTop + article.offsetHeight;
    for (let y = article.offsetTop; y < last; y += scroller.clientHeight) {
      scroller.scrollTop = y;
      await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
      for (const item of article.querySelectorAll<HTMLElement>('[role="treeitem"]')) {
        const parts = [...(item.querySelector(".proof-row")?.children ?? [])].map((part) => {
          if (!(part instanceof HTMLElement)) throw new Error("a part that is no text");
          return part.classList.contains("subject") ? `${part.innerText} <${part.title}>` : part.innerText;
        });
        lines.set(item.offsetTop, `${"  ".repeat(Number(item.ariaLevel) - 1)}${parts.join(" | ")}`);
      }
    }
    return [...lines].sort(([a], [b]) => a - b).map(([, line]) => line);
  });
}

/** Picks the row of this number, from 0, of an unfolded proof. */
export async function pickRow(proof: Locator, number: number): Promise<void> {
  const place = await proof.evaluate(async (article, { index, row }) => {
    const scroller = article.closest(".proofs");
    if (scroller === null || !(article instanceof HTMLElement)) throw new Error("no proof");
    scroller.scrollTop = article.offsetTop + index * row;
    let item: HTMLElement | undefined;
    for (let frames = 0; item === undefined && frames < 300; frames++) {
      await new Promise(requestAnimationFrame);
      item = [...article.querySelectorAll<HTMLElement>('[role="treeitem"]')].find((each) => each.offsetTop === (index + 1) * row);
    }
    return item?.querySelector<HTMLElement>(".proof-row")?.dataset["proof"];
  }, { index: number, row: kRow });
  await proof.locator(`[data-proof="${place ?? "none"}"]`).click();
}

/** What the card of an inference must say of a node: its rule, the rules of its premises in order, and each fact that it holds. */
export function expectedCard({ rule, equation, premises, ...node }: RawNode) {
  const { at, port, action, parameter, of, service, operation, value, requires, args, kwargs, refinement } = node;
  const facts: readonly (readonly [string, string | undefined])[] = [
    ["at", at],
    ["port", port],
    ["action", action === undefined ? undefined : String(action)],
    ["parameter", parameter],
    ["of", of],
    ["calls", service === undefined ? undefined : `${service}.${operation ?? "?"}`],
    ["value", value === undefined ? undefined : literal(value)],
    ["reads", requires?.join(", ")],
    ["args", args === undefined ? undefined : literal(args)],
    ["kwargs", kwargs === undefined || Object.keys(kwargs).length === 0 ? undefined : literal(kwargs)],
    ["refinement", refinement],
  ];
  return {
    title: `${rule} (${equation})`,
    premises: premises.map((premise) => premise.rule),
    facts: facts.filter(([, text]) => text !== undefined).map(([name, text]) => `${name}: ${text ?? ""}`),
  };
}

/** The card as it is shown. */
export function shownCard(card: Locator) {
  return card.evaluate((aside) => {
    const text = (element: Element | null) => (element instanceof HTMLElement ? element.innerText : "");
    return {
      title: text(aside.querySelector("h3")),
      premises: [...aside.querySelectorAll(".premises small")].map(text),
      facts: [...aside.querySelectorAll("dl > div")].map((pair) => `${text(pair.querySelector("dt"))}: ${text(pair.querySelector("dd"))}`),
    };
  });
}
