import { describe, expect, it } from "vitest";
import { applyGesture, initialView, pageOf, type Gesture, type View } from "../../shared/session/view";

const following: View = { ...initialView, follow: true, collapsed: new Set(["R/A", "R/A/B", "R/C"]) };
const show = (view: View, ...paths: readonly string[]) => applyGesture(view, { type: "show_active", paths });

describe("following", () => {
  it("opens the states around what is active, and no other", () => {
    expect([...show(following, "R/A/B/X").collapsed]).toEqual(["R/C"]);
    expect(show(following, "R/X").collapsed).toBe(following.collapsed);
    expect(show(following, "R/A/B/X").follow).toBe(true);
  });
  it("leaves a level that does not have all of it", () => {
    const inside = { ...following, focus: "R/A" };
    expect(show(inside, "R/A/B/X").focus).toBe("R/A");
    expect(show(inside, "R/C/D/X").focus).toBe("R/C/D");
    expect(show(inside, "R/C/D/X", "R/C/E").focus).toBe("R/C");
    expect(show(inside, "R/A/B", "R/C/D").focus).toBeUndefined();
  });
  it.each<[string, Gesture]>([
    ["jumps", { type: "jump", selection: { kind: "node", path: "R/A" } }],
    ["enters a state", { type: "enter", path: "R/A" }],
    ["folds a state", { type: "toggle", path: "R/C" }],
    ["folds all", { type: "collapse_all", paths: ["R/A"] }],
  ])("ends when the user %s", (_, gesture) => expect(applyGesture(following, gesture).follow).toBe(false));
  it("goes on in another run, and with another selection", () => {
    expect(applyGesture(following, { type: "forget_run" }).follow).toBe(true);
    expect(applyGesture(following, { type: "select", selection: { kind: "node", path: "R/A" } }).follow).toBe(true);
  });
});

describe("the drawer", () => {
  it("opens with what it showed last", () => {
    const log = applyGesture(initialView, { type: "drawer", drawer: "log" });
    const closed = applyGesture(log, { type: "toggle_drawer" });
    expect([closed.drawer, applyGesture(closed, { type: "toggle_drawer" }).drawer]).toEqual(["closed", "log"]);
  });
});

describe("the page of an address", () => {
  it("is one that needs no document", () => expect(["task", "services", "cell", "edit", "moon", undefined].map(pageOf)).toEqual(["task", "services", "cell", undefined, undefined, undefined]));
});
