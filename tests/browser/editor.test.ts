// The page that edits a document, on the real server: what is edited is drawn, kept by the server, and followed by a second page.
import type { Page } from "playwright-core";
import { openFixture, settled, type Fixture } from "./fixture";

let fixture: Fixture;
beforeAll(async () => {
  fixture = await openFixture();
});
afterAll(() => fixture.close());

const node = (page: Page, path: string) => page.locator(`.react-flow [data-path="${path}"]`);

describe("a document that is opened for editing", () => {
  it("is named by the address, drawn, and follows edits", async () => {
    const { page, url, send, screenshot } = fixture;
    await send("PUT", "/documents/task", { rcm: 1, root: { state: "Root", first: "A", children: [{ state: "A", ports: [{ name: "done", when: "True", to: "B" }] }, { state: "B" }] } });
    await page.goto(`${url}/pro/?edit=task`);
    await settled(page);
    await node(page, "Root/A").waitFor();
    const { document } = (await send("GET", "/documents/task")) as { document: { root: { children: { meta: { id: string } }[] } } };
    await node(page, "Root/A").click({ position: { x: 20, y: 8 } });
    await send("POST", "/documents/task/edits", { compound: { kind: "rename", id: document.root.children[0]?.meta.id ?? "", name: "Approach" }, author: "Ann", revision: 1 });
    await node(page, "Root/Approach").waitFor();
    await expect.poll(() => node(page, "Root/Approach").evaluate((element) => element.matches(".is-selected, :has(.is-selected)"))).toBe(true);
    await screenshot("editor");
  });
});
