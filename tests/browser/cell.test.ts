// Hands in the 3D view, on the real server: links are pulled, a part is taken away and put back. That the
// robot feels a hand: tests/integration/test_person.py.
import { find, view, type Region } from "./pointer";
import { openFixture, type Fixture } from "./fixture";
import { kSoon } from "./patience";

let fixture: Fixture;

beforeAll(async () => {
  fixture = await openFixture();
  await fixture.page.goto(`${fixture.url}/pro/`);
  await view(fixture.page).waitFor(kSoon);
});
afterAll(() => fixture.close());

interface Touch {
  readonly hand: string;
  readonly body: string;
  readonly force: readonly number[];
}
const person = async () =>
  (await (await fetch(`${fixture.url}/api/v1/cell/person`)).json()) as { readonly hands: readonly Touch[]; readonly absent: readonly string[] };

const kArm: Region = [0.4, 0.62, 0.3, 0.5];
const kTable: Region = [0.42, 0.68, 0.56, 0.78];

describe("the cell", () => {
  it("lets a link be pulled by the mouse, and shows the force that the server says", async () => {
    await fixture.page.getByRole("button", { name: "Pull" }).click();
    const { x, y } = await find(fixture.page, /^(link_[4-7]|gripper)$/, kArm);
    await fixture.page.mouse.down();
    await fixture.page.mouse.move(x + 40, y, { steps: 5 });
    await expect.poll(async () => Math.hypot(...((await person()).hands[0]?.force ?? [0])), kSoon).toBeGreaterThan(15);
    const [held] = (await person()).hands;
    expect(held?.body).toMatch(/^(link_[4-7]|gripper)$/);
    await expect.poll(() => fixture.page.locator(".cell-force").first().innerText(), kSoon).toMatch(/^\d\d+ N$/);
    await fixture.screenshot("cell-pull");
    await fixture.page.mouse.up();
    await expect.poll(async () => (await person()).hands, kSoon).toEqual([]);
  });

  it("lets a part be taken away and put back", async () => {
    const scene = (await (await fetch(`${fixture.url}/api/v1/cell`)).json()) as { readonly bodies: readonly { readonly name: string; readonly fixed: boolean }[] };
    const parts = scene.bodies.filter(({ fixed }) => !fixed).map(({ name }) => name);
    const { x, y } = await find(fixture.page, new RegExp(`^(${parts.join("|")})$`), kTable);
    await fixture.page.mouse.click(x, y, { button: "right" });
    const take = fixture.page.getByRole("menuitem", { name: /^Take away/ });
    await take.waitFor();
    await fixture.screenshot("cell-menu");
    const part = (await take.innerText()).replace("Take away ", "");
    await take.click();
    await expect.poll(async () => (await person()).absent, kSoon).toEqual([part]);
    await fixture.page.getByRole("button", { name: `Put back ${part}` }).click();
    await expect.poll(async () => (await person()).absent, kSoon).toEqual([]);
    await expect.poll(() => fixture.page.getByRole("button", { name: /^Put back/ }).count(), kSoon).toBe(0);
  });
});
