// What is collapsed in a task stays so in its next run, also when the document was edited in between.
import { openFixture, type Fixture } from "./fixture";
import { letMove } from "./hands";
import { kSoon } from "./patience";

let fixture: Fixture;

beforeAll(async () => {
  fixture = await openFixture();
});
afterAll(() => fixture.close());

const send = async (method: string, path: string, body?: unknown) => (await fixture.send(method, path, body)) as { readonly id: string };

const composite = (name: string, id: string) => ({ state: name, first: "Go", children: [{ state: "Go", meta: { id: `${id}-go` } }], meta: { id } });

/** Stores a task that ends at once, with composites of these names and ids. */
const store = (...children: readonly object[]) =>
  send("PUT", "/documents/folding", { rcm: 1, name: "folding", root: { state: "Root", first: "Rest", children, ports: [{ name: "done", when: "True" }], meta: { id: "root" } } });

const tree = () => fixture.page.getByRole("tree", { name: "State tree" });

/** Path -> whether it is expanded, of the composites in the tree. */
async function expanded(): Promise<Record<string, string | null>> {
  const items = await tree().getByRole("treeitem").all();
  const pairs = await Promise.all(items.map(async (item) => [(await item.getAttribute("aria-label")) ?? "", await item.getAttribute("aria-expanded")] as const));
  return Object.fromEntries(pairs.filter(([, open]) => open !== null));
}

describe("folding", () => {
  it("follows a state that was renamed between two runs, and not its name", async () => {
    await store(composite("Pick", "a"), composite("Place", "b"), composite("Rest", "c"));
    const { id } = await send("POST", "/cores", { document: "folding", arguments: {} });
    await send("POST", `/cores/${id}/start`);
    await fixture.page.goto(`${fixture.url}/pro/`);
    await tree().getByRole("button", { name: "Collapse Pick" }).click();
    await expect.poll(expanded, kSoon).toEqual({ Root: "true", "Root/Pick": "false", "Root/Place": "true", "Root/Rest": "true" });
    await store(composite("Fetch", "a"), composite("Pick", "b"), composite("Rest", "c"));
    await fixture.page.getByRole("button", { name: "Run again" }).click();
    await expect.poll(expanded, kSoon).toEqual({ Root: "true", "Root/Fetch": "false", "Root/Pick": "true", "Root/Rest": "true" });
  });
  it("is kept when the page turns to the next run before the model of this one has arrived", async () => {
    const folded = { Root: "true", "Root/Fetch": "false", "Root/Pick": "true", "Root/Rest": "true" };
    await expect.poll(expanded, kSoon).toEqual(folded);
    // While its model is not there, nobody knows whether a run moves something.
    await letMove(fixture.page, "folding");
    const asked: string[] = [];
    await fixture.page.route("**/api/v1/cores/*/native", (route, request) => {
      asked.push(request.url());
      if (asked.length > 1) return route.continue();
    });
    for (const count of [1, 2]) {
      await fixture.page.getByRole("button", { name: "Run again" }).click();
      await expect.poll(() => asked.length, kSoon).toBe(count);
    }
    await expect.poll(expanded, kSoon).toEqual(folded);
  });
});
