// Conversations about documents.
import { calls, writeExact, type Client } from "../../api/typescript/src/index";
import { all, refused } from "./asserting";
import { task, wrong } from "./models";
import { Server } from "./servers";

let server: Server;
let race: Client;
beforeAll(async () => {
  server = await Server.start();
  race = server.client();
});
afterAll(() => server.stop());

describe("documents", () => {
  it("a wrong document is checked as it is refused", async () => {
    const found = await race.documents.check(wrong());
    expect(found.map(({ path, code }) => [path, code])).toEqual([["Root", "first"], ["Root.done", "syntax"]]);
    expect(found[0]?.message).toBe("`first`: there is no child `Nowhere`");
    expect(found[1]).toMatchObject({ text: "when", line: 1 });
    const error = await refused(422, "first", race.documents.put("wrong", wrong()));
    expect([error.errors, error.path]).toEqual([found, "Root"]);
    expect(error.message).toContain(`Root: ${found[0]?.message}; Root.done: `);
  });

  it("a check stores nothing", async () => {
    expect(await race.documents.check(task("ticking", { name: "unstored" }), { name: "unstored" })).toEqual([]);
    await refused(404, "not_found", race.documents.get("unstored"));
    const stored = await race.documents.put("kept", task("ticking", { name: "kept" }));
    expect(await race.documents.check(task("ticking", { name: "kept", last: 7 }), { name: "kept" })).toEqual([]);
    expect(await race.documents.get("kept")).toEqual(stored);
  });

  it("a document is put under a condition", async () => {
    const held = (last: number) => task("ticking", { name: "held", last });
    const first = await race.documents.put("held", held(5), { isNew: true, author: "Ada", message: "begin" });
    expect(first).toMatchObject({ revision: 1, author: "Ada", message: "begin", errors: [] });
    await refused(412, "conflict", race.documents.put("held", held(5), { isNew: true }));
    const second = await race.documents.put("held", held(6), { ifRevision: 1 });
    await refused(412, "conflict", race.documents.put("held", held(7), { ifRevision: 1 }));
    expect(await race.documents.get("held")).toEqual(second);
    expect((await race.documents.get("held", { revision: 1 })).document).toEqual(first.document);
    expect((await race.documents.revisions("held")).revisions.map(({ revision }) => revision)).toEqual([2, 1]);
    await refused(412, "conflict", race.documents.delete("held", { ifRevision: 1 }));
    expect(await race.documents.delete("held", { ifRevision: 2 })).toEqual({ removed: "held" });
  });

  it("a draft keeps its violations", async () => {
    const draft = await race.documents.put("draft", wrong("draft"), { draft: true });
    expect(draft.errors).toEqual(await race.documents.check(wrong("draft")));
    expect((await all(race.documents.all())).map(({ name, errors }) => [name, errors])).toContainEqual(["draft", 2]);
    await refused(422, "first", race.cores.create("draft"));
  });

  it("an edit is made once and refused by what others did", async () => {
    const { root } = (await race.documents.put("edited", task("ticking", { name: "edited" }))).document as unknown as { readonly root: { readonly meta: { readonly id: string } } };
    const change = { op: "set", id: root.meta.id, field: "doc", value: "counts" } as const;
    const once = { revision: 1, request: "e1", author: "Ada" };
    const accepted = await race.documents.edit("edited", [change], once);
    expect(accepted).toMatchObject({ revision: 2, author: "Ada", operations: [change] });
    expect(await race.documents.edit("edited", [change], once)).toEqual(accepted);
    expect(await race.documents.edit("edited", [{ ...change, value: "counts ticks" }], { revision: 1 }), "rebased").toMatchObject({ revision: 3 });
    const now = (await race.documents.get("edited")).document as unknown as { readonly root: { readonly children: readonly { readonly meta: { readonly id: string } }[] } };
    const ping = now.root.children[0]?.meta.id ?? "";
    await race.documents.edit("edited", [{ op: "remove", id: ping }], { revision: 3, author: "Ada" });
    const late = race.documents.edit("edited", [{ op: "set", id: ping, field: "doc", value: "late" }], { revision: 3, author: "Bob" });
    const error = await refused(409, "conflict", late);
    expect(error.path).toBe("operations/0/id");
    expect(error.message).toContain("Ada");
    expect((await race.documents.get("edited")).document).toMatchObject({ root: { doc: "counts ticks" } });
  });

  it("names are one part of a path", async () => {
    for (const name of ["a?draft=true", "a#b", "%2e%2e", "ä b"]) {
      const error = await refused(422, "name", race.documents.put(name, task("ticking")));
      expect(error.errors[0]?.path).toBe(name);
    }
    await refused(404, "not_found", race.documents.put("a/../../cores", task("ticking")));
    // A browser would take them for another path.
    for (const name of [".", ".."]) await expect(race.documents.delete(name)).rejects.toThrow(TypeError);
  });

  it("what is no json is not sent", async () => {
    await expect(race.documents.put("nan", { rcm: NaN })).rejects.toThrow(TypeError);
    await expect(race.documents.put("object", { rcm: Symbol("none") })).rejects.toThrow(TypeError);
    for (const none of [[undefined], [1n], Infinity]) expect(() => writeExact(none)).toThrow(TypeError);
    await expect(race.send(calls.getDocument("ticking", { ifNoneMatch: '"1"\r\nX-Evil: 1' }))).rejects.toThrow(TypeError);
  });
});
