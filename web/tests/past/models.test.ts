import { describe, expect, it } from "vitest";
import type { Journal, Native } from "../../generated/messages";
import { Refusal } from "../../shared/edit/refusal";
import { modelsOfRun } from "../../shared/past/models";

const meta = (id: string) => ({ meta: { id } });
const native = { document: { rcm: 1, root: { state: "Root", ...meta("root"), first: "A", children: [{ state: "A", ...meta("a") }] } }, origin: { Root: "Root", "Root/A": "Root/A" } } as unknown as Native;

type Entry = Journal["entries"][number];
const tick: Entry["input"] = { kind: "event", service: "timer", event: "tick", data: null };
const renamed = (id: string, name: string, origin: Readonly<Record<string, string | null>>): Entry["input"] => ({ kind: "edit", edit: { operations: [{ op: "set", id, field: "state", value: name }] }, origin });
const journal = (...inputs: readonly Entry["input"][]): Journal => ({
  header: { native, arguments: {}, services: {}, semantics: "1", budgets: { steps: 1, value_units: 1, micro_steps: 1 } },
  entries: inputs.map((input, i) => ({ position: i + 1, input })),
});

const nameIn = (found: Native | Refusal): unknown => (found instanceof Refusal ? found.code : found.document.root.children?.map((child) => ("state" in child ? child.state : undefined)));

describe("the models of a run", () => {
  const models = modelsOfRun(journal({ kind: "start" }, tick, renamed("a", "B", { "Root/A": null, "Root/B": "Root/A" }), tick, renamed("a", "C", {})));
  it("are that of its header, and from the macro step of an edit on the edited one", () => {
    expect([1, 2, 3, 4, 5, 6].map((step) => nameIn(models(step)))).toEqual([["A"], ["A"], ["B"], ["B"], ["C"], ["C"]]);
  });
  it("are the same object between two edits", () => {
    expect(models(1)).toBe(native);
    expect(models(4)).toBe(models(3));
    expect(models(4)).not.toBe(models(5));
  });
  it("have the origins of their paths, with what an edit changes of them", () => {
    const then = models(3);
    expect(then instanceof Refusal ? then : then.origin).toEqual({ Root: "Root", "Root/B": "Root/A" });
  });
  it("are not known from an edit on that cannot be applied", () => {
    const broken = modelsOfRun(journal({ kind: "start" }, renamed("gone", "B", {}), tick));
    expect([1, 2, 3].map((step) => nameIn(broken(step)))).toEqual([["A"], "not_found", "not_found"]);
  });
});
