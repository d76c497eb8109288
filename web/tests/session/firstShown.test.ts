import { describe, expect, it } from "vitest";
import type { Core } from "../../generated/messages";
import type { State } from "../../shared/model/model";
import { buildTree } from "../../shared/model/modelTree";
import { applyEvent, emptySession, type Session } from "../../shared/session/session";
import { firstShown, followModel } from "../../shared/session/firstShown";
import { initialView, type Shown } from "../../shared/session/view";

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

describe("firstShown", () => {
  const core = (id: string, document: string): Core => ({ id, document, status: "ended", paused: false, stepping: false, step: 1, micro: 0, waiting: 0, arguments: {}, breakpoints: [] });
  const known = applyEvent(emptySession, { type: "update", update: { type: "cores", cores: [core("1", "pick"), core("2", "pick"), core("3", "place")] } });
  const watching = (id: string): Session => applyEvent(known, { type: "watched", id });
  const model = { name: "", services: {}, library: [], root: state("Root", "r", pick("Pick", "p")) };
  const last = applyEvent(watching("1"), { type: "model", id: "1", model });
  const edited = buildTree(state("Root", "r", pick("Fetch", "p")));

  it("of another run of the document is what was shown of the last one", () => {
    expect(firstShown(edited, watching("2"), last, shown("Root/Pick", "Root/Pick"))).toEqual(shown("Root/Fetch", "Root/Fetch"));
  });
  it("of another document, or where nothing was shown before, is the whole task, folded only if it is large", () => {
    const large = buildTree(state("Root", "r", ...Array.from({ length: 40 }, (_, i) => pick(`P${i}`))));
    for (const [now, then] of [[watching("3"), last], [watching("2"), watching("1")], [watching("2"), emptySession]] as const) {
      expect(firstShown(edited, now, then, shown("Root/Pick", "Root/Pick"))).toEqual(shown(undefined));
      expect(firstShown(large, now, then, shown("Root/Pick")).collapsed.size).toBe(40);
    }
  });
  it("says nothing but what a drawing depends on: pages, panels and the selection stay as they are", () => {
    const view = { ...initialView, page: "cell", ...shown("Root/Pick") } as const;
    for (const id of ["2", "3"]) expect(Object.keys(firstShown(edited, watching(id), last, view)).sort()).toEqual(["collapsed", "detail", "focus"]);
  });
});
