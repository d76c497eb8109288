// A run that is over: how it ended is said, with the ports that led there, each a link.
import { openFixture, settled, type Fixture } from "./fixture";

let fixture: Fixture;
beforeAll(async () => {
  fixture = await openFixture();
});
afterAll(() => fixture.close());

const root = {
  state: "Root",
  first: "Pick",
  results: [{ name: "tries", initial: 3 }],
  children: [{ state: "Pick", first: "Wait", children: [{ state: "Wait", entry: "svc.timer.start(0.05)", ports: [{ name: "late", when: "svc.timer.start.result" }] }], ports: [{ name: "error", when: "chi.Wait.port.late" }] }],
  ports: [{ name: "error", when: "chi.Pick.port.error" }],
};

it("an ended run says through which port, why, and with what results", async () => {
  const { page, url, send, screenshot } = fixture;
  await send("PUT", "/documents/failing", { rcm: 1, root });
  const { id } = (await send("POST", "/cores", { document: "failing" })) as { readonly id: string };
  await page.goto(`${url}/pro/?run=${id}`);
  await settled(page);
  await send("POST", `/cores/${id}/start`);
  const card = page.getByRole("region", { name: "How it ended" });
  await card.waitFor();
  const rows = card.getByRole("list", { name: "Causes" }).getByRole("listitem");
  await expect.poll(() => rows.count()).toBe(3);
  expect((await rows.allInnerTexts()).map((text) => text.split("\n")[0])).toEqual(["Root.error", "Root/Pick.error", "Root/Pick/Wait.late"]);
  expect(await card.innerText()).toContain("response timer.start");
  expect(await card.getByRole("region", { name: "Results" }).innerText()).toContain("3");
  await screenshot("end");
  await card.getByRole("button", { name: "Root/Pick/Wait.late" }).click();
  await page.locator('.port.is-selected[aria-label="Port Root/Pick/Wait.late"]').waitFor();
});
