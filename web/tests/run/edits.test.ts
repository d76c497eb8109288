import { describe, expect, it } from "vitest";
import type { Core } from "../../generated/messages";
import { editText, modelKey } from "../../shared/run/edits";
import { inputText } from "../../shared/run/inputText";

const core: Core = {
  id: "1",
  document: "pick",
  revision: 3,
  status: "running",
  paused: false,
  stepping: false,
  step: 7,
  micro: 0,
  waiting: 0,
  arguments: {},
  breakpoints: [],
  live: true,
  model: 0,
};

describe("an edit of a running task", () => {
  it("is not spoken of when there is none", () => {
    expect(editText(core)).toBeUndefined();
  });

  it("names the active states that it removes, and the parameters that would have no value", () => {
    const waits = [{ path: "Pick/Grasp", id: "g" }, { path: "Pick/Move", parameter: "goal" }];
    expect(editText({ ...core, waiting_edit: { revision: 4, waits } })).toEqual({
      title: "Revision 4 of pick waits until Grasp is left",
      waits: [
        { path: "Pick/Grasp", id: "g", text: "Pick/Grasp is active, and the edit removes it" },
        { path: "Pick/Move", text: "Pick/Move would have no value for its parameter goal" },
      ],
      holds: "Until this changes, the run goes on with revision 3.",
    });
  });

  it("says in its title until when it waits", () => {
    const title = (...waits: readonly { readonly path: string; readonly parameter?: string }[]) => editText({ ...core, waiting_edit: { revision: 4, waits } })?.title.replace("Revision 4 of pick ", "");
    expect(title({ path: "P/A" }, { path: "P/A/B" })).toBe("waits until A and B are left");
    expect(title(...["A", "B", "C", "D"].map((name) => ({ path: `P/${name}` })))).toBe("waits until 4 states are left");
    expect(title({ path: "P/A", parameter: "goal" })).toBe("waits for a value of the parameter goal of A");
    expect(title()).toBe("is not in this run yet");
  });

  it("says that a paused run gets it when it goes on", () => {
    expect(editText({ ...core, paused: true, waiting_edit: { revision: 4, waits: [] } })?.holds).toBe("It is delivered when the run goes on.");
    expect(editText({ ...core, waiting_edit: { revision: 4, waits: [] } })?.holds).toBe("It is delivered at the end of this macro step.");
  });

  it("is what somebody has to confirm, once the run moves something", () => {
    const text = editText({ ...core, waiting_edit: { revision: 4, unconfirmed: true, waits: [] } });
    expect(text).toMatchObject({ title: "Revision 4 of pick waits to be confirmed", confirms: 4 });
    expect(text?.holds).toContain("until who has the controls confirms the edit.");
    expect(editText({ ...core, waiting_edit: { revision: 4, waits: [] } })).not.toHaveProperty("confirms");
  });

  it("that cannot be executed is named with its errors, before one that waits", () => {
    const errors = [{ path: "Pick", code: "first", message: "names no child" }];
    const text = editText({ ...core, refused_edit: { revision: 5, errors }, waiting_edit: { revision: 4, waits: [] } });
    expect(text?.title).toBe("Revision 5 of pick has 1 error and cannot be executed");
    expect(text?.waits).toEqual([{ path: "Pick", error: errors[0], text: "Pick: names no child" }]);
  });

  it("changes the key of the model, by which the page loads it anew", () => {
    expect(modelKey({ ...core, model: 8 })).not.toBe(modelKey(core));
  });

  it("is an input of the run, and so is what somebody forces", () => {
    expect(inputText({ kind: "edit", revision: 4, edit: { operations: [] } })).toBe("edit: revision 4");
    expect(inputText({ kind: "force", force: { path: "Pick", scope: "var", name: "n", value: 1 } })).toBe("force Pick var.n = 1");
    expect(inputText({ kind: "force", force: { path: "Pick", scope: "port", name: "done" } })).toBe("force Pick.done");
  });
});
