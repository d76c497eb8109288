import { describe, expect, it } from "vitest";
import type { Core } from "../../generated/messages";
import type { State } from "../../shared/model/model";
import { kNoPlaces } from "../../shared/drawing/places";
import { buildTree } from "../../shared/model/modelTree";
import { applyEvent, emptySession, type Session } from "../../shared/session/session";
import { firstShown, followModel, lastShown } from "../../shared/session/firstShown";
import { initialView, type Shown, type View } from "../../shared/session/view";

function state(name: string, id?: string, ...children: readonly State[]): State {
  return { kind: "state", name, parameters: [], results: [], variables: [], actions: [], children, ports: [], ...(id === undefined ? {} : { id }) };
}
const pick = (name: string, id?: string): State => state(name, id, state("Grasp"));
const shown = (focus: string | undefined, ...collapsed: readonly string[]): Shown => ({ focus, collapsed: new Set(collapsed), detail: "ports" });

describe("followModel", () => {
  const before = buildTree(state("Root", "r", pick("Pick", "p"), pick("Place", "q")));
  const follow = (root: State, what: Shown): Shown => followModel(what, before, buildTree(root));
  it("finds what was renamed or moved by its id", () => {
    const after = state("Root", "r", state("Group", "g", pick("Fetch", "p")), pick("Place", "q"));
    expect(follow(after, shown("Root/Pick", "Root/Pick", "Root/Place"))).toEqual(shown("Root/Group/Fetch", "Root/Group/Fetch", "Root/Place"));
  });
  it("does not take another state for it that has its name now", () => {
    const after = state("Root", "r", pick("Place", "p"), pick("Pick", "new"));
    expect(follow(after, shown("Root/Place", "Root/Pick"))).toEqual(shown(undefined, "Root/Place"));
  });
  it("without ids, or with ids since the edit, finds what is at the same path", () => {
    const plain = buildTree(state("Root", undefined, pick("Pick")));
    const what = shown("Root/Pick", "Root/Pick");
    expect(followModel(what, plain, plain)).toEqual(what);
    expect(followModel(what, plain, before)).toEqual(what);
    expect(followModel(what, before, plain)).toEqual(what);
  });
  it("leaves out what is gone or has no children any more", () => {
    expect(follow(state("Root", "r", state("Pick", "p")), shown("Root/Place", "Root/Pick", "Root/Place"))).toEqual(shown(undefined));
  });
});

describe("followModel of a task that has become large", () => {
  const many = (count: number): readonly State[] => Array.from({ length: count }, (_, i) => state(`L${i}`, `l${i}`));
  const before = buildTree(state("Root", "r", pick("Pick", "p"), pick("Place", "q"), state("Leaf", "leaf")));
  const grown = buildTree(state("Root", "r", pick("Fetch", "p"), pick("Place", "q"), state("Leaf", "leaf", state("New")), state("Group", "g", ...many(60))));
  it("collapses the composites that are new, also one that was a state without children, and no other", () => {
    expect(followModel(shown(undefined), before, grown)).toEqual(shown(undefined, "Root/Leaf", "Root/Group"));
  });
  it("keeps what was collapsed, wherever it is now", () => {
    expect(followModel(shown("Root/Place", "Root/Pick"), before, grown)).toEqual(shown("Root/Place", "Root/Fetch", "Root/Leaf", "Root/Group"));
  });
  it("collapses none that was expanded before", () => {
    expect(followModel(shown(undefined), grown, grown)).toEqual(shown(undefined));
  });
  it("collapses nothing in a task that is still small", () => {
    const small = buildTree(state("Root", "r", pick("Pick", "p"), pick("Place", "q"), state("Group", "g", pick("Grasp", "s"))));
    expect(followModel(shown(undefined), before, small)).toEqual(shown(undefined));
  });
});

describe("firstShown", () => {
  const core = (id: string, document: string): Core => ({ id, document, revision: 1, status: "ended", paused: false, stepping: false, step: 1, micro: 0, waiting: 0, arguments: {}, breakpoints: [], live: false, model: 0 });
  const known = applyEvent(emptySession, { type: "update", update: { type: "cores", cores: [core("1", "pick"), core("2", "pick"), core("3", "place")] } });
  const turnTo = (session: Session, id: string): Session => applyEvent(session, { type: "watched", id });
  const model = { name: "", services: {}, library: [], root: state("Root", "r", pick("Pick", "p")) };
  const one = applyEvent(turnTo(known, "1"), { type: "model", id: "1", key: "1/0", model, places: kNoPlaces });
  const edited = buildTree(state("Root", "r", pick("Fetch", "p")));
  const asBefore = shown("Root/Fetch", "Root/Fetch");
  const last = lastShown(one, shown("Root/Pick", "Root/Pick"), undefined);

  it("of another run of the document is what was shown of the last one", () => {
    expect(firstShown(edited, turnTo(one, "2").document, last, "ports")).toEqual(asBefore);
  });
  it.each(["2", "3"])("is so too after the page turned to run %s, whose model did not arrive", (id) => {
    const between = turnTo(one, id);
    expect(firstShown(edited, turnTo(between, "2").document, lastShown(between, shown(undefined), last), "ports")).toEqual(asBefore);
  });
  it("is so too if the run that was shown is removed", () => {
    const removed = applyEvent(one, { type: "update", update: { type: "core_removed", id: "1" } });
    expect(firstShown(edited, turnTo(removed, "2").document, lastShown(removed, shown("Root/Pick", "Root/Pick"), undefined), "ports")).toEqual(asBefore);
  });
  it("of another document, or where nothing was shown before, is the whole task, folded only if it is large", () => {
    const large = buildTree(state("Root", "r", ...Array.from({ length: 40 }, (_, i) => pick(`P${i}`))));
    const unseen = lastShown(turnTo(known, "1"), shown("Root/Pick", "Root/Pick"), undefined);
    for (const [id, before] of [["3", last], ["2", unseen], ["2", undefined]] as const) {
      const { document } = turnTo(one, id);
      expect(firstShown(edited, document, before, "ports")).toEqual(shown(undefined));
      expect(firstShown(large, document, before, "ports").collapsed.size).toBe(40);
    }
  });
  it("says nothing but what a drawing depends on, in the detail of now: pages, panels and the selection stay as they are", () => {
    const view: View = { ...initialView, page: "cell", ...shown("Root/Pick") };
    const before = lastShown(one, view, undefined);
    for (const document of ["pick", "place"]) {
      const first = firstShown(edited, document, before, "slim");
      expect([Object.keys(first).sort(), first.detail]).toEqual([["collapsed", "detail", "focus"], "slim"]);
    }
  });
});
