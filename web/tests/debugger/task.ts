// A task with ids, and one state without: Root with A (ports done, late; one action) and B, with C inside.
import { buildTree } from "../../shared/model/modelTree";
import type { Port, State } from "../../shared/model/model";

const state = (name: string, more: Partial<State> = {}): State => ({ kind: "state", name, parameters: [], results: [], variables: [], actions: [], children: [], ports: [], ...more });
const port = (name: string, id?: string): Port => ({ name, when: "True", ...(id !== undefined && { id }) });

export const tree = buildTree(
  state("Root", {
    id: "root",
    children: [
      state("A", { id: "a", actions: [{ id: "act1", when: "True", do: "" }, { id: "act2", when: "True", do: "" }], ports: [port("done", "a-done"), port("late")] }),
      state("B", { id: "b", children: [state("C", { id: "c" })] }),
      state("Old"),
    ],
  }),
);
