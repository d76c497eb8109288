// Random edits of any tree; some are refused.
import type { Edit } from "../../generated/messages";
import type { JsonObject } from "../../shared/json";
import type { Operation } from "../../shared/edit/apply";
import type { ListName } from "../../shared/edit/element";
import { elementOf, listOf, type Tree } from "../../shared/edit/tree";
import type { Random } from "./random";

const kLists: readonly ListName[] = ["children", "children", "ports", "actions", "variables"];

export class RandomEdits {
  private count = 0;

  /** `prefix`: of the ids of what is inserted, one for each source. In a tree with more than `most` elements, some are removed where others would be inserted. */
  constructor(
    private readonly random: Random,
    private readonly prefix: string,
    private readonly most = Infinity,
  ) {}

  /** One to three operations on what an author of `tree` sees. */
  edit(tree: Tree): Edit {
    const all = [...tree.elements.keys()];
    const count = this.random.chance(0.3) ? 1 + this.random.pick(3) : 1;
    return { operations: Array.from({ length: count }, () => this.operation(tree, all)) };
  }

  private operation(tree: Tree, all: readonly string[]): Operation {
    const { random } = this;
    const what = random.pick(10);
    if (what < 3 && all.length <= this.most) {
      const list = random.of(kLists);
      return { op: "insert", ...this.place(tree, this.state(tree, all), list), node: this.node(list, 0) };
    }
    const id = random.of(all);
    if (what <= 3) return { op: "remove", id };
    if (what > 6) return this.set(tree, all);
    const { parent, list } = elementOf(tree, id);
    if (list === "children" && random.chance(0.1)) return { op: "move", id, ...this.place(tree, "", "library") };
    if (list === "library" && random.chance(0.5)) return { op: "move", id, ...this.place(tree, this.state(tree, all), "children") };
    return { op: "move", id, ...this.place(tree, random.chance(0.5) ? parent : this.state(tree, all), list ?? "children") };
  }

  private state(tree: Tree, all: readonly string[]): string {
    return this.random.of(all.filter((id) => elementOf(tree, id).kind === "state"));
  }

  private place(tree: Tree, parent: string, list: ListName): { readonly parent: string; readonly list: ListName; readonly after?: string } {
    const siblings = listOf(tree, parent, list);
    return siblings.length === 0 || this.random.chance(0.3) ? { parent, list } : { parent, list, after: this.random.of(siblings) };
  }

  private node(list: ListName, depth: number): JsonObject {
    const { random } = this;
    const meta = { id: `${this.prefix}${this.count++}` };
    const name = `N${random.pick(5)}`;
    if (list === "actions") return { when: "True", do: "var.v = 1", meta };
    if (list === "ports") return { name, ...(random.chance(0.3) ? { after: "2.5" } : { when: "True" }), meta };
    if (list !== "children") return { name, initial: random.pick(9) / 4, meta };
    if (random.chance(0.2)) return { barrier: name, to: [], meta };
    const children = depth < 2 && random.chance(0.5) ? { children: [this.node(list, depth + 1), this.node(list, depth + 1)] } : {};
    return { state: name, ...children, ...(random.chance(0.5) && { ports: [this.node("ports", depth)] }), meta };
  }

  private set(tree: Tree, all: readonly string[]): Operation {
    const { random } = this;
    const id = random.of(all);
    if (random.chance(0.15)) return { op: "set", id: "", field: random.of(["layout", "meta"]), key: id, ...this.value() };
    if (random.chance(0.1)) return { op: "set", id: "", field: random.of(["notes", "services"]), key: `k${random.pick(4)}`, ...(random.chance(0.7) && { value: "text" }) };
    if (random.chance(0.2)) return { op: "set", id, field: "meta", key: random.of(["title", "icon", "min"]), ...this.value() };
    const value = `S${random.pick(5)}`;
    switch (elementOf(tree, id).kind) {
      case "action":
        return { op: "set", id, field: "do", value: `var.v = ${random.pick(9)}` };
      case "port":
        return { op: "set", id, field: random.of(["to", "to", "after", "when", "name"]), ...(random.chance(0.7) && { value }) };
      case "state":
        return { op: "set", id, field: random.of(["doc", "doc", "state", "entry"]), value };
      case "barrier":
        return { op: "set", id, field: "to", value: [value] };
      default:
        return { op: "set", id, field: "name", value };
    }
  }

  private value(): { readonly value?: JsonObject | number } {
    const { random } = this;
    if (random.chance(0.3)) return {};
    return { value: random.chance(0.5) ? random.pick(9) : { x: random.pick(9) / 2, y: [true, null, "ü"] } };
  }
}
