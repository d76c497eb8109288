import { describe, expect, it } from "vitest";
import { buildTree } from "../../shared/model/modelTree";
import { readModel } from "../../shared/model/readModel";
import { addressWith, placeOfAddress } from "../../shared/session/address";
import { isElsewhere, isSamePlace, pageOfPlace, placeInModel, toPlace } from "../../shared/session/placeInAddress";
import { applyGesture, initialView } from "../../shared/session/view";

const tree = buildTree(readModel({ rcm: 1, root: { state: "Root", first: "A", children: [{ state: "A", first: "B", children: [{ state: "B", ports: [{ name: "done", when: "True" }] }] }] } }).root);
const show = (search: string, view = initialView) => applyGesture(view, toPlace(tree, placeOfAddress(search), "derivation"));
const written = (view = initialView) => addressWith("", placeInModel(view, "derivation", undefined));

describe("the place in the model", () => {
  it("is in the address, and comes out of it as it was", () => {
    const view = show("?in=Root/A&sel=Root/A/B.done&below=log");
    expect(view).toMatchObject({ focus: "Root/A", selection: { kind: "port", address: "Root/A/B.done" }, drawer: "log" });
    expect(written(view)).toBe("?in=Root/A&sel=Root/A/B.done&below=log");
    expect(written(show("?sel=Root/A&below=closed"))).toBe("?sel=Root/A&below=closed");
    expect(written()).toBe("?");
  });
  it("says what is asked about of the state that is selected", () => {
    const view = show("?sel=Root/A&why=action.1");
    expect(view.asked).toEqual({ action: 1 });
    expect(written(view)).toBe("?sel=Root/A&why=action.1");
    expect(written(show("?sel=Root/A&why=par.width"))).toBe("?sel=Root/A&why=par.width");
    expect(show("?sel=Root/A/B.done&why=action.1").asked).toBeUndefined();
    expect(show("?sel=Root/A&why=action.x").asked).toBeUndefined();
    expect(written(applyGesture(view, { type: "select", selection: { kind: "node", path: "Root" } }))).toBe("?sel=Root");
    // It is of the run: an edit of the document, which others may make, leaves it.
    expect(applyGesture(view, { type: "carry", of: "document", before: tree, after: tree }).asked).toEqual({ action: 1 });
  });
  it("is shown with what is in collapsed states, and brought into view", () => {
    const folded = applyGesture(initialView, { type: "collapse_all", paths: ["Root/A", "Root/A/B"] });
    const view = show("?sel=Root/A/B", folded);
    expect([...view.collapsed]).toEqual(["Root/A/B"]);
    expect(view.reveal).toBe(initialView.reveal + 1);
  });
  it("is nowhere where the model does not have it", () => {
    expect(show("?in=Root/Gone&sel=Root/A.gone&below=kitchen")).toMatchObject({ focus: undefined, selection: undefined, drawer: "derivation" });
  });
  it("is a step of the browser's history if another state is entered, not if that has another name now", () => {
    expect(isElsewhere(tree, {}, { in: "Root/A" })).toBe(true);
    expect(isElsewhere(tree, { in: "Root/A" }, {})).toBe(true);
    expect(isElsewhere(tree, { in: "Root/Old" }, { in: "Root/A" })).toBe(false);
    expect(isElsewhere(tree, { in: "Root/A" }, { in: "Root/A", sel: "Root/A/B", below: "log" })).toBe(false);
    expect(isElsewhere(tree, {}, { top: "7" })).toBe(true);
    expect([isSamePlace({}, { below: undefined }), isSamePlace({}, { sel: "Root" })]).toEqual([true, false]);
  });
  it("is on the page that the address asks for", () => {
    expect(["", "?edit=a", "?edit=a&page=cell", "?page=services", "?page=edit"].map((search) => pageOfPlace(placeOfAddress(search)))).toEqual(["task", "edit", "cell", "services", "task"]);
    // Of a library state only the page that edits it tells.
    expect(placeInModel({ ...initialView, page: "edit" }, "derivation", "7").top).toBe("7");
    expect(placeInModel(initialView, "derivation", "7").top).toBeUndefined();
  });
});
