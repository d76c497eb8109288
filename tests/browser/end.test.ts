// A run that is over: how it ended is said, with the ports that led there, each a link.
import type { Locator } from "playwright-core";
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
  await expect.poll(async () => (await rows.allInnerTexts()).map((text) => text.split("\n")[0])).toEqual(["Root.error", "Root/Pick.error", "Root/Pick/Wait.late"]);
  await expect.poll(() => card.innerText()).toContain("response timer.start");
  await expect.poll(() => card.innerText()).toMatch(/Took \d+\.\d s, 2 macro steps/);
  expect(await card.getByRole("region", { name: "Results" }).innerText()).toContain("3");
  await expect.poll(() => page.locator('.port[aria-label="Port Root.error"]').getAttribute("class")).toContain("ends-badly");
  await expect.poll(() => page.locator(".ends-badly").count()).toBe(1);
  await screenshot("end");
  await card.getByRole("button", { name: "Root/Pick/Wait.late" }).click();
  await page.locator('.port.is-selected[aria-label="Port Root/Pick/Wait.late"]').waitFor();
  await page.keyboard.press("Escape");
  await rows.first().getByRole("button", { name: "macro step 2, micro step 3" }).click();
  const picked = page.locator('[role="treeitem"][aria-selected="true"][aria-level]').filter({ has: page.locator(".proof-row") });
  await expect.poll(() => page.locator(".proofs article").filter({ has: picked }).getAttribute("aria-label")).toBe("Micro step 3");
  await expect.poll(() => picked.innerText()).toMatch(/PTrigger[^]*Root\.error/);
  await expect.poll(() => picked.evaluate((row) => row.getBoundingClientRect().bottom <= (row.closest(".proofs")?.getBoundingClientRect().bottom ?? 0))).toBe(true);
  await card.getByRole("button", { name: /^response timer\.start/ }).click();
  await expect.poll(() => new URL(page.url()).searchParams.get("at")).toBe("2.0");
  await expect.poll(() => page.getByRole("list", { name: "Entries" }).locator('[aria-current="step"]').innerText()).toMatch(/^2\.0\s+response/);
});

it("so does one that went well, and one that was stopped, which has no port", async () => {
  const { page, url, send, screenshot } = fixture;
  const good = { state: "Root", first: "Pick", results: [{ name: "tries", initial: 3 }], children: [{ state: "Pick", ports: [{ name: "success", when: "True" }] }], ports: [{ name: "done", when: "chi.Pick.port.success" }] };
  await send("PUT", "/documents/good", { rcm: 1, root: good });
  await send("PUT", "/documents/endless", { rcm: 1, root: { state: "Root", ports: [{ name: "never", when: "False" }] } });
  const begin = async (document: string) => {
    const { id } = (await send("POST", "/cores", { document })) as { readonly id: string };
    await page.goto(`${url}/pro/?run=${id}`);
    await settled(page);
    await send("POST", `/cores/${id}/start`);
    return id;
  };
  const card = page.getByRole("region", { name: "How it ended" });
  await begin("good");
  await expect.poll(() => card.innerText()).toMatch(/Left through done\s+Took \d+\.\d s, 1 macro step\s/);
  await expect.poll(() => card.getByRole("list", { name: "Causes" }).getByRole("listitem").count()).toBe(2);
  expect(await page.locator(".ends-badly").count()).toBe(0);
  await screenshot("end-good");
  const id = await begin("endless");
  await expect.poll(() => page.getByRole("status", { name: "Run status" }).innerText()).toContain("Running");
  await send("POST", `/cores/${id}/stop`);
  await expect.poll(() => card.innerText()).toMatch(/Stopped\s+Took \d+\.\d s, 2 macro steps/);
  await screenshot("end-stopped");
});

it("one that faulted says in which macro step, and upon what, which is shown among the calls", async () => {
  const { page, url, send, screenshot } = fixture;
  const children = [{ state: "Wait", entry: "svc.timer.start(0.05)", ports: [{ name: "late", when: "svc.timer.start.result", to: "Divide" }] }, { state: "Divide", entry: "var.n = 1 / 0", variables: [{ name: "n" }] }];
  await send("PUT", "/documents/broken", { rcm: 1, root: { state: "Root", first: "Wait", children, ports: [{ name: "never", when: "False" }] } });
  const { id } = (await send("POST", "/cores", { document: "broken" })) as { readonly id: string };
  await page.setViewportSize({ width: 1366, height: 768 });
  await page.goto(`${url}/pro/?run=${id}`);
  await settled(page);
  await send("POST", `/cores/${id}/start`);
  const fault = page.getByRole("region", { name: "Fault" });
  const causes = fault.getByRole("list", { name: "Causes" });
  await expect.poll(() => causes.innerText()).toMatch(/^Root\/Wait\.late\s+svc\.timer\.start\.result\s+macro step 2, micro step 1$/);
  await expect.poll(() => fault.getByRole("list", { name: "Places in the code" }).innerText()).toBe("entry var.n = 1 / 0");
  await screenshot("end-fault-chain");
  await fault.getByRole("button", { name: "entry var.n = 1 / 0" }).click();
  await page.locator('.state.is-selected[data-path="Root/Divide"]').waitFor();
  await page.keyboard.press("Escape");
  await causes.getByRole("button", { name: /^macro step/ }).click();
  await expect.poll(() => page.locator('.proofs article').first().getAttribute("aria-label")).toBe("Micro step 1");
  await fault.getByRole("button", { name: /^in macro step 2, upon response timer\.start/ }).click();
  await expect.poll(() => new URL(page.url()).searchParams.get("at")).toBe("2.0");
  await expect.poll(() => page.getByRole("list", { name: "Entries" }).locator('[aria-current="step"]').innerText()).toMatch(/^2\.0\s+response/);
  const status = page.getByRole("status", { name: "Run status" });
  const look = (part: Locator) => part.evaluate((element) => ({ size: Number.parseFloat(getComputedStyle(element).fontSize), background: getComputedStyle(element).backgroundColor }));
  expect((await look(status.locator("strong"))).size).toBeGreaterThanOrEqual(16);
  expect((await look(status)).background).not.toBe((await look(page.locator(".runbar"))).background);
  await screenshot("end-fault");
  // The word in the run bar leads to the card, also while something is selected.
  await page.getByRole("treeitem", { name: "Root/Divide", exact: true }).getByRole("button").last().click();
  await expect.poll(() => fault.count()).toBe(0);
  await status.getByRole("button", { name: /^Faulted/ }).focus();
  await page.keyboard.press("Enter");
  await fault.waitFor();
  await expect.poll(() => page.locator(".state.is-selected").count()).toBe(0);
});
