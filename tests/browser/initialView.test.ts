// The initial view in windows of usual size: the whole task, with readable conditions.
import type { Page } from "playwright-core";
import { openFixture, type Fixture } from "./fixture";

let fixture: Fixture;

beforeAll(async () => {
  fixture = await openFixture();
  await fetch(`${fixture.url}/api/v1/cores`, { method: "POST", headers: { "content-type": "application/json" }, body: JSON.stringify({ document: "pick" }) });
});
afterAll(() => fixture.close());

/** Height of a condition's letters on the screen [px]: their size, as far as the drawing is zoomed. */
const letters = (page: Page) =>
  page
    .getByRole("button", { name: "Port Pick/GetPose.success", exact: true })
    .locator("code")
    .evaluate((code) => {
      const zoom = code.getBoundingClientRect().height / code.clientHeight;
      return getComputedStyle(code).visibility === "visible" ? parseFloat(getComputedStyle(code).fontSize) * zoom : 0;
    });

const isWhole = (page: Page) =>
  page.locator(".canvas").evaluate((canvas) => {
    const frame = canvas.getBoundingClientRect();
    return [...canvas.querySelectorAll(".state, .port")].every((element) => {
      const box = element.getBoundingClientRect();
      return box.left >= frame.left && box.right <= frame.right && box.top >= frame.top && box.bottom <= frame.bottom;
    });
  });

describe.each([
  { width: 1280, height: 800 },
  { width: 1440, height: 900 },
])("in a window of $width by $height", (size) => {
  it("shows all of Pick with its conditions; the derivation and readable conditions beside it are a click away", async () => {
    const page = await fixture.openPage(size);
    await page.getByRole("button", { name: "Conditions", pressed: true }).waitFor();
    await expect.poll(() => letters(page)).toBeGreaterThan(7);
    await expect.poll(() => isWhole(page)).toBe(true);
    const port = (name: string) => page.getByRole("button", { name: `Port Pick/Release.${name}`, exact: true });
    expect(await port("success").locator("code").innerText()).toBe("svc.gripper.release.result");
    expect(await port("error").locator("code").innerText()).toBe("svc.gripper.release.error");
    expect(await page.getByRole("region", { name: "Derivation" }).count()).toBe(0);
    await fixture.screenshot(`first-${size.width}`, page);
    await page.getByRole("tab", { name: "Derivation" }).click();
    await page.getByRole("region", { name: "Derivation" }).waitFor();
    await fixture.screenshot(`first-${size.width}-derivation`, page);
    // There the whole task is too small to read; on request its beginning is as large as the width allows.
    await page.getByRole("button", { name: "Names" }).click();
    await page.getByRole("button", { name: "Conditions", pressed: false }).click();
    await expect.poll(() => letters(page)).toBeGreaterThan(7);
    await fixture.screenshot(`conditions-${size.width}`, page);
    await page.close();
  });
});
