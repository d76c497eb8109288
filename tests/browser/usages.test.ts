// Where a document names its elements is what the real server changes when it renames them.
import { usagesOf } from "../../web/shared/code/usages";
import { nameOfElement } from "../../web/shared/edit/commands/command";
import type { JsonValue } from "../../web/shared/json";
import { treeOf } from "../../web/tests/edit/documents";
import { openFixture, type Fixture } from "./fixture";

let fixture: Fixture;
beforeAll(async () => {
  fixture = await openFixture();
});
afterAll(() => fixture.close());

interface Stored {
  readonly revision: number;
  readonly document: JsonValue;
}
interface Accepted {
  readonly revision: number;
  readonly operations: readonly { readonly id: string; readonly field: string }[];
}

it("for every element of the demo that has a name of its own", async () => {
  const { send } = fixture;
  const { document: demo } = (await send("GET", "/documents/demonstrator")) as Stored;
  await send("PUT", "/documents/renamed", demo);
  const { document, ...stored } = (await send("GET", "/documents/renamed")) as Stored;
  let { revision } = stored;
  const tree = treeOf(document);
  let [renamed, found] = [0, 0];
  for (const id of tree.elements.keys()) {
    if (nameOfElement(tree, id) === "") continue;
    const accepted = (await send("POST", "/documents/renamed/edits", { compound: { kind: "rename", id, name: "Another_name" }, author: "Ann", revision }).catch(() => undefined)) as Accepted | undefined;
    if (accepted === undefined) continue;
    const changed = accepted.operations.map((operation) => `${operation.id} ${operation.field}`).filter((place) => place !== `${id} state` && place !== `${id} barrier` && place !== `${id} name`);
    const usages = usagesOf(tree, id).map((usage) => `${usage.id} ${usage.field}`);
    expect([...new Set(usages)].sort(), nameOfElement(tree, id)).toEqual([...new Set(changed)].sort());
    ({ revision } = (await send("POST", "/documents/renamed/edits", { undo: true, author: "Ann", revision: accepted.revision })) as Accepted);
    [renamed, found] = [renamed + 1, found + usages.length];
  }
  expect(renamed).toBeGreaterThan(100);
  expect(found).toBeGreaterThan(200);
});
