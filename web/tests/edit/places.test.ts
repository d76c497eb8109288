import { describe, expect, it } from "vitest";
import type { ServerError } from "../../generated/messages";
import { messageAtField, placeOf } from "../../shared/edit/places";
import { treeOf } from "./documents";

const id = (name: string) => ({ meta: { id: name } });
const tree = treeOf({
  rcm: 1,
  library: [{ state: "Grasp", ...id("grasp"), parameters: [{ name: "force", from: "par.f", ...id("force") }], children: [{ state: "Close", ...id("close") }] }],
  root: {
    state: "Root", ...id("root"),
    children: [
      {
        state: "A", ...id("a"), parameters: [{ name: "x", ...id("x") }, { name: "x", ...id("x2") }],
        actions: [{ when: "True", do: "pass", ...id("act0") }, { when: "(", do: "pass", ...id("act1") }], ports: [{ name: "done", when: "(", ...id("done") }],
      },
      { state: "Link", link: "Grasp", ...id("link") },
      { barrier: "Both", to: ["B"], ...id("both") },
    ],
  },
});
const at = (path: string, message: string, code = "type") => placeOf(tree, { path, code, message });
const inCode = (path: string, element: string, text: NonNullable<ServerError["text"]>) => placeOf(tree, { path, code: "syntax", message: "what it says", id: element, text });

describe("the place of an error", () => {
  it("is the text of code that it names: of a state, an action, a port or a parameter", () => {
    expect(inCode("Root/A", "a", "entry")).toEqual({ id: "a", field: "entry" });
    expect(inCode("Root/A", "act1", "when")).toEqual({ id: "act1", field: "when" });
    expect(inCode("Root/A.done", "done", "when")).toEqual({ id: "done", field: "when" });
    expect(inCode("Root/A", "x", "from")).toEqual({ id: "x", field: "from" });
    expect(inCode("library/Grasp/Close", "close", "exit")).toEqual({ id: "close", field: "exit" });
  });
  it("is the link, of a parameter's expression that it takes over from the library", () => {
    expect(inCode("Root/Link", "force", "from")).toEqual({ id: "link", field: "" });
  });
  it("is a parameter, and of two with one name the later one", () => {
    expect(at("Root/A", "parameter `x` has both `value` and `from`", "parameter")).toEqual({ id: "x", field: "from" });
    expect(at("Root/A", "parameter `x` is declared twice", "duplicate")).toEqual({ id: "x2", field: "name" });
  });
  it("is the field that its code is about", () => {
    expect(at("Root/A.done", "leads to `C`, which is no sibling of its state", "port_target")).toEqual({ id: "done", field: "to" });
    expect(at("Root/Both", "leads to `B`, which is no sibling state", "barrier_target")).toEqual({ id: "both", field: "to" });
    expect(at("Root", "`first`: there is no child `X`", "first")).toEqual({ id: "root", field: "first" });
  });
  it("is the element, where no field is known; the document, where nothing is found", () => {
    expect(at("Root/A", "what nobody knows", "other")).toEqual({ id: "a", field: "" });
    expect(at("Gone/A", "it is not there")).toEqual({ id: "", field: "" });
    expect(at("", "more than 2000 states", "too_large")).toEqual({ id: "", field: "" });
  });
});

describe("what an error says beside its field", () => {
  it("does not name the field again, but a line below the first", () => {
    expect(messageAtField({ path: "Root/A", code: "syntax", message: "action 1, `when`: expected `)`", line: 1, column: 2 })).toBe("expected `)`");
    expect(messageAtField({ path: "Root/A", code: "syntax", message: "entry: expected `)`", line: 3, column: 2 })).toBe("line 3, column 2: expected `)`");
  });
});
