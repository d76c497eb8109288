// Tasks whose texts are those of an attacker (scriptPayloads.ts): one that runs, and a draft, whose names are such texts, too.
import { payloads } from "./scriptPayloads";

const kPerState = 16;

/** The texts of each state. */
export const groups: readonly (readonly string[])[] = Array.from({ length: Math.ceil(payloads.length / kPerState) }, (_, i) => payloads.slice(i * kPerState, (i + 1) * kPerState));

/** As the function language and JSON write it. */
export const literal = (text: string): string => JSON.stringify(text);
const all = (texts: readonly string[]): string => texts.join("\n");

const stateOf = (texts: readonly string[], i: number) => ({
  state: `S${i}`, doc: all(texts), meta: { id: `s${i}`, [texts[0] ?? ""]: texts },
  parameters: texts.map((text, k) => ({ name: `p${k}`, value: text, unit: text, doc: text, type: "string" })),
  variables: texts.filter((_, k) => k % 4 === 0).map((text, k) => ({ name: `v${k}`, initial: [text], unit: text, doc: text, type: { optional: { list: { enum: [text] } } } })),
  results: [{ name: "texts", initial: texts, doc: all(texts) }],
  // The log of a page has 200 lines.
  entry: texts.flatMap((text, k) => (k % 2 === 0 ? [`print(${literal(text)}, ${literal(texts[k + 1] ?? "")})`] : [])).join("\n"),
  exit: texts.map((text) => `var.v0 = [${literal(text)}]`).join("\n"),
  actions: texts.filter((_, k) => k % 4 === 0).map((text) => ({ when: `par.p0 == ${literal(text)} + 'x'`, do: `# ${text.replace(/[\r\n\u2028]/g, " ")}\nprint(${literal(text)})` })),
  ports: texts.filter((_, k) => k % 2 === 0).map((text, k) => ({ name: `q${k}`, when: `par.p0 == ${literal(text)} + 'x'` })),
});

const comments = Object.fromEntries(
  groups.flatMap((texts, i) =>
    texts.flatMap((text, k) => [
      [`comment:c${i}-${k}`, { about: `s${i}`, author: text, time: k % 2 === 0 ? "2026-11-27T10:00:00.000Z" : text, text, ...(k % 4 === 3 && { answers: `c${i}-${k - 1}`, edited: text }) }] as const,
      ...(k === 0 ? [[`resolved:c${i}-${k}`, { author: text, time: text }] as const] : []),
    ]),
  ),
);

/** Calls this when it is entered; ends through `done` so much later [s], with all texts as results. */
export const hostileTask = (entry: string, lasts: number) => ({
  rcm: 1, name: payloads[0],
  root: {
    state: "Root", doc: all(payloads), first: "All", meta: { id: "root" }, entry,
    parameters: [{ name: "texts", value: payloads, doc: payloads[1], unit: payloads[2] }, { name: "choice", value: payloads[3], type: { enum: payloads } }, { name: "text", value: payloads[4], type: "string", doc: all(payloads) }],
    results: [{ name: "all", initial: Object.fromEntries(payloads.map((text) => [text, text])) }],
    children: [{ barrier: "All", to: groups.map((_, i) => `S${i}`), meta: { id: "all" } }, ...groups.map(stateOf)],
    ports: [{ name: "done", after: `${lasts}.0` }],
  },
  library: [{ state: "Part", doc: all(payloads), entry: literal(payloads[0] ?? ""), meta: { id: "part" } }],
  layout: { s0: { x: 1, y: 1, parent: payloads[0], side: payloads[0] }, [payloads[0] ?? ""]: { x: 1, y: 1 } },
  meta: { notes: Object.fromEntries(groups.map((texts, i) => [`s${i}`, all(texts)])), ...comments, ...Object.fromEntries(payloads.map((text) => [text, { [text]: text }])) },
});

/** Nothing of it can be executed. */
export const hostileDraft = {
  rcm: 1, name: payloads[0], services: Object.fromEntries(payloads.slice(0, 40).map((text) => [text, text])),
  root: {
    state: payloads[0], first: payloads[1], doc: all(payloads), oracle: { kind: "expr", expr: all(payloads) },
    parameters: payloads.slice(0, 40).map((text) => ({ name: text, from: text })),
    children: [
      ...payloads.map((text, i) => ({
        state: text, doc: text, entry: text, exit: text, first: text,
        parameters: [{ name: text, from: text, unit: text, doc: text }], variables: [{ name: text, initial: text }],
        actions: [{ when: text, do: text }], ports: [{ name: text, when: text, to: payloads[i + 1] ?? text }], keep: [text],
      })),
      ...payloads.slice(0, 20).map((text) => ({ barrier: text, to: [text] })),
      ...payloads.slice(0, 20).map((text) => ({ state: text, link: text, oracle: { kind: "external", call: text } })),
    ],
  },
  library: payloads.slice(0, 40).map((text) => ({ state: text, doc: text })),
};

/** A draft of which the page can say only what is wrong with it. */
export const unreadableDraft = { rcm: 1, root: { state: "Root", variables: payloads.map((text, i) => ({ name: `v${i}`, type: { record: { [text]: text } } })) } };

/** Skills with such texts for people, and a task that has each of them as a step, with such texts as values. */
export const hostileSkills = {
  rcm: 1,
  library: payloads.map((text, i) => ({
    state: `S${i}`, doc: text, results: [{ name: "r", meta: { title: text, domain: text } }],
    parameters: [
      { name: "t", value: text, type: "string", doc: text, unit: text, meta: { title: text, domain: "text" } },
      { name: "c", value: text, doc: text, meta: { title: text, choices: [{ value: text, title: text }] } },
      { name: "p", value: text, meta: { title: text, domain: "pose" } },
      { name: "l", value: [text], meta: { title: text, domain: "labels" } },
      { name: "n", value: 1, unit: text, type: "number", meta: { title: text } },
    ],
    ports: [{ name: "success", when: "False", meta: { title: text } }, { name: "other", when: "False", meta: { title: text } }, { name: "error", when: "False", meta: { title: text, advice: text } }],
    meta: { skill: true, title: text, icon: text, category: "flow" },
  })),
  root: {
    state: "Root", first: "Task", meta: { title: payloads[0] },
    children: [{ state: "Task", doc: all(payloads), first: "S0", children: payloads.map((text, i) => ({ state: `S${i}`, link: `S${i}`, meta: { title: text }, ports: [{ name: "success", ...(i + 1 < payloads.length && { to: `S${i + 1}` }) }] })), meta: { title: payloads[1] } }],
  },
};

/** A task of this description. */
export const describedTask = (doc: string) => ({ rcm: 1, root: { state: "Root", doc } });

/** A task that faults with this text. */
export const faultingTask = (text: string) => ({ rcm: 1, root: { state: "Root", variables: [{ name: "n" }], entry: `var.n = {"a": 1}[${literal(text)}]` } });

/** A task that only calls this. */
export const callingTask = (...calls: readonly string[]) => ({ rcm: 1, root: { state: "Root", entry: calls.join("\n"), ports: [{ name: "never", when: "False" }] } });

