// A macro step that is too long for one turn of its core: the server sends it in parts, the page shows it as one step.
import { openFixture, type Fixture } from "./fixture";
import { proofCount } from "./proofText";
import { kSoon } from "./patience";

let fixture: Fixture;

beforeAll(async () => {
  fixture = await openFixture();
});
afterAll(() => fixture.close());

/** Goes from Ping to Pong and back, until Ping was entered a hundred times, in one macro step. */
const model = {
  rcm: 1,
  name: "long",
  root: {
    state: "Root",
    first: "Ping",
    children: [
      { state: "Ping", keep: true, results: [{ name: "n", initial: 0 }], entry: "res.n = res.n + 1", ports: [{ name: "go", when: "res.n < 100", to: "Pong" }] },
      { state: "Pong", ports: [{ name: "back", when: "True", to: "Ping" }] },
    ],
    ports: [{ name: "done", when: "chi.Ping.res.n >= 100" }],
  },
};


describe("a macro step that comes in parts", () => {
  it("is one step of the derivation, with its micro steps numbered through", async () => {
    const { page, url } = fixture;
    const messages: string[] = [];
    page.on("websocket", (socket) => socket.on("framereceived", ({ payload }) => void messages.push(String(payload))));
    await fixture.send("PUT", "/documents/long", model);
    const { id } = (await fixture.send("POST", "/cores", { document: "long", arguments: {} })) as { readonly id: string };
    await page.goto(`${url}/pro/`);
    await page.getByText("The derivation of each macro step appears here").waitFor();
    // From its snapshot on, the page is sent the derivations; steps of before are recomputed, and come whole.
    await expect.poll(() => messages.some((message) => message.includes(`core/${id}/derivation`)), kSoon).toBe(true);
    await fixture.send("POST", `/cores/${id}/start`);
    const steps = page.getByRole("list", { name: "Macro steps" }).getByRole("listitem");
    await expect.poll(() => steps.allInnerTexts(), kSoon).toEqual([expect.stringMatching(/\d+ micro$/)]);
    const { steps: derived } = (await fixture.send("GET", `/cores/${id}/derivations?from=1&to=1`)) as { readonly steps: readonly { readonly micro: readonly unknown[] }[] };
    const count = derived[0]?.micro.length ?? 0;
    await expect.poll(() => messages.join("").split('"complete":').length - 1, kSoon).toBeGreaterThan(1);
    await expect.poll(() => steps.allInnerTexts(), kSoon).toEqual([expect.stringContaining(`${count} micro`)]);
    await expect.poll(() => proofCount(page), kSoon).toBe(count);
    await page.locator(".proofs").evaluate((element) => (element.scrollTop = element.scrollHeight));
    await page.getByRole("article", { name: `Micro step ${count}`, exact: true }).waitFor();
    // However many there are, those in view are in the page.
    expect(await page.locator(".derivation *").count()).toBeLessThan(300);
  });
});
