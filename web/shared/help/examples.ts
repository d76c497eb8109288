// The figures of the help: tasks that are drawn there, and that the page can store as documents to be tried.
import type { Document } from "../../generated/messages";

export interface Example {
  /** Of the document that is made of it. */
  readonly name: string;
  readonly document: Document;
}

const example = (name: string, root: Document["root"], services: Document["services"] = {}): Example => ({ name, document: { rcm: 1, name, services, root } });

const gripper = { gripper: "gripper" };

/** Thesis, Figures 3.2 and 3.3. */
export const grasp = example(
  "grasp",
  {
    state: "Grasp",
    doc: "Closes the gripper (thesis, Figure 3.3).",
    parameters: [{ name: "width", value: 0.05, type: "number", unit: "m" }, { name: "force", value: 20, type: "number", unit: "N" }],
    results: [{ name: "actual_width" }],
    entry: "svc.gripper.grasp(width=par.width, force=par.force)",
    actions: [{ when: "svc.gripper.grasp.result", do: "res.actual_width = svc.gripper.grasp.result.actual_width" }],
    ports: [{ name: "success", when: "available(res.actual_width)" }, { name: "error", when: "svc.gripper.grasp.error" }],
  },
  gripper,
);

/** Thesis, Figure 3.4: a composite with two children in sequence. */
export const pick = example("pick-example", {
  state: "Pick",
  doc: "Two states, one after the other (thesis, Figure 3.4).",
  parameters: [{ name: "width", value: 0.05 }],
  first: "Move",
  children: [
    { state: "Move", entry: 'print("moves")', ports: [{ name: "success", when: "True", to: "Grasp" }] },
    { state: "Grasp", parameters: [{ name: "width", from: "par.width" }], entry: 'print("grasps", par.width)', ports: [{ name: "success", when: "True" }] },
  ],
  ports: [{ name: "success", when: "chi.Grasp.port.success" }],
});

/** Thesis, Figure 3.5: a barrier joins two states and activates two others. */
export const barrier = example("barrier-example", {
  state: "Both",
  doc: "What runs side by side (thesis, Figure 3.5).",
  first: "Split",
  children: [
    { state: "Split", ports: [{ name: "go", when: "True", to: "Fork" }] },
    { barrier: "Fork", to: ["Watch", "Work"] },
    { state: "Watch", entry: 'print("watches")', ports: [{ name: "done", after: "2", to: "Join" }] },
    { state: "Work", entry: 'print("works")', ports: [{ name: "done", after: "1", to: "Join" }] },
    { barrier: "Join", to: ["End"] },
    { state: "End", entry: 'print("both are done")', ports: [{ name: "done", when: "True" }] },
  ],
  ports: [{ name: "done", when: "chi.End.port.done" }],
});

/** Ports with the same source: the first that is fulfilled fires. */
export const choice = example("choice-example", {
  state: "Choice",
  doc: "The order of ports decides where two can fire.",
  first: "Weigh",
  children: [
    { state: "Weigh", results: [{ name: "grams" }], entry: "res.grams = 120", ports: [{ name: "heavy", when: "res.grams > 100", to: "Crane" }, { name: "any", when: "available(res.grams)", to: "Hand" }] },
    { state: "Crane", entry: 'print("crane")', ports: [{ name: "done", when: "True" }] },
    { state: "Hand", entry: 'print("hand")', ports: [{ name: "done", when: "True" }] },
  ],
  ports: [{ name: "done", when: "chi.Crane.port.done or chi.Hand.port.done" }],
});

/** Values that go down as parameters and up as results. */
export const values = example("values-example", {
  state: "Mean",
  doc: "Parameters go down, results come up.",
  parameters: [{ name: "a", value: 3 }, { name: "b", value: 5 }],
  results: [{ name: "mean" }],
  first: "Add",
  children: [
    {
      state: "Add",
      parameters: [{ name: "left", from: "par.a" }, { name: "right", from: "par.b" }],
      results: [{ name: "sum" }],
      entry: "res.sum = par.left + par.right",
      ports: [{ name: "done", when: "True" }],
    },
  ],
  actions: [{ when: "available(chi.Add.res.sum)", do: "res.mean = chi.Add.res.sum / 2" }],
  ports: [{ name: "done", when: "available(res.mean)" }],
});

/** Thesis, Figure 3.9: a task that goes on where it was. */
export const history = example("history-example", {
  state: "Application",
  doc: "After an error the task goes on where it was (thesis, Figure 3.9).",
  first: "Task",
  variables: [{ name: "errors", initial: 0 }],
  children: [
    {
      state: "Task",
      oracle: { kind: "history", resume: ["error"] },
      first: "One",
      children: [
        { state: "One", entry: 'print("one")', ports: [{ name: "next", after: "1", to: "Two" }] },
        { state: "Two", entry: 'print("two")', ports: [{ name: "next", after: "0.5", to: "Three" }] },
        { state: "Three", entry: 'print("three")', ports: [{ name: "done", after: "1" }] },
      ],
      ports: [{ name: "done", when: "chi.Three.port.done" }, { name: "error", after: "2", to: "Handling" }],
    },
    { state: "Handling", entry: 'print("handles the error")', ports: [{ name: "handled", after: "1", to: "Task" }] },
  ],
  ports: [{ name: "done", when: "chi.Task.port.done" }],
});

/** A port that fires after a time. */
export const timeOut = example("time-out-example", {
  state: "Question",
  doc: "Waits for somebody, but not for ever.",
  first: "Ask",
  children: [
    { state: "Ask", entry: 'svc.display.ask(text="Ready?", buttons=["Yes"])', ports: [{ name: "yes", when: "svc.display.ask.result", to: "Go" }, { name: "late", after: "20" }] },
    { state: "Go", entry: 'print("goes")', ports: [{ name: "done", when: "True" }] },
  ],
  ports: [{ name: "done", when: "chi.Go.port.done" }, { name: "gave_up", when: "chi.Ask.port.late" }],
}, { display: "display" });

export const examples: readonly Example[] = [grasp, pick, barrier, choice, values, history, timeOut];
