import { describe, expect, it } from "vitest";
import { fileOf, freeDocumentName, nameOfFile, nameRefusal, newDocumentText } from "../../shared/documents/names";

const taken = new Set(["pick", "pick-2"]);

describe("the name of a new document", () => {
  it("has 1 to 64 of A-Z a-z 0-9 _ -, and no other document has it", () => {
    for (const name of ["place", "Pick", "2_parts", "-", "a".repeat(64)]) expect(nameRefusal(name, taken)).toBeUndefined();
    expect(nameRefusal("", taken)).toBe("A document needs a name.");
    expect(nameRefusal("a".repeat(65), taken)).toBe("A name has at most 64 characters.");
    for (const name of ["a b", "ä", "a.b", "a/b"]) expect(nameRefusal(name, taken)).toBe("A name is made of A-Z, a-z, 0-9, _ and -.");
    expect(nameRefusal("pick", taken)).toBe("There is a document pick.");
  });
  it("is the wished one, or the next with a number, never longer than a name may be", () => {
    expect(freeDocumentName("place", taken)).toBe("place");
    expect(freeDocumentName("pick", taken)).toBe("pick-3");
    const long = "a".repeat(64);
    expect(freeDocumentName(long, new Set([long]))).toBe(`${"a".repeat(62)}-2`);
  });
  it("is what a file is called, and the file what the document is", () => {
    expect(["pick.rcm.json", "pick.JSON", "My task (1).json", "pick"].map(nameOfFile)).toEqual(["pick", "pick", "My_task_1_", "pick"]);
    expect(nameOfFile(".json")).toBe("document");
    expect(nameOfFile(`${"a".repeat(80)}.json`)).toHaveLength(64);
    expect(nameOfFile(fileOf("pick"))).toBe("pick");
  });
});

describe("a new document", () => {
  it("has a root of the same name, as far as a state can have it", () => {
    const root = (name: string) => (JSON.parse(newDocumentText(name)) as { root: unknown }).root;
    expect(root("pick")).toEqual({ state: "pick" });
    expect(root("2-parts")).toEqual({ state: "_2_parts" });
    expect(root("-a")).toEqual({ state: "_a" });
  });
});
