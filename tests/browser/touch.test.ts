// The cell under fingers, on a phone: a long press opens a part's menu, a drag pulls, and all parts are in a list. On the real server.
import { devices, type CDPSession, type Page } from "playwright-core";
import { tap } from "./fingers";
import { find, view, type Place, type Region } from "./pointer";
import { openFixture, type Fixture } from "./fixture";
import { kSoon } from "./patience";

let fixture: Fixture;
let phone: Page;
let fingers: CDPSession;

beforeAll(async () => {
  fixture = await openFixture();
  const context = await fixture.openContext({ ...devices["Pixel 7"] });
  phone = await context.newPage();
  fingers = await context.newCDPSession(phone);
  await phone.goto(`${fixture.url}/pro/`);
  await tap(phone.getByRole("tab", { name: "Cell" }));
  await view(phone).waitFor(kSoon);
  await tap(button("Pull"));
});
afterAll(() => fixture.close());

const button = (name: string) => phone.getByRole("button", { name, exact: true });
const menu = () => phone.getByRole("menuitem", { name: /^Take away/ });

interface Person {
  readonly hands: readonly { readonly body: string; readonly force: readonly number[] }[];
  readonly absent: readonly string[];
}
const person = async () => (await (await fetch(`${fixture.url}/api/v1/cell/person`)).json()) as Person;
async function parts(): Promise<readonly string[]> {
  const scene = (await (await fetch(`${fixture.url}/api/v1/cell`)).json()) as { readonly bodies: readonly { readonly name: string; readonly fixed: boolean }[] };
  return scene.bodies.filter(({ fixed }) => !fixed).map(({ name }) => name);
}

const touch = (type: "touchStart" | "touchMove" | "touchEnd", ...at: readonly Place[]) => fingers.send("Input.dispatchTouchEvent", { type, touchPoints: [...at] });

const kArm: Region = [0.42, 0.64, 0.3, 0.45];
const kTable: Region = [0.4, 0.8, 0.56, 0.75];

/** Where a part is [px]. */
let place: Place;

describe("the cell under fingers", () => {
  it("lets a link be pulled, and lets go with the finger", async () => {
    const { x, y } = await find(phone, /^(link_[4-7]|gripper)$/, kArm);
    await touch("touchStart", { x, y });
    for (let i = 1; i <= 5; i++) await touch("touchMove", { x: x + 8 * i, y });
    await expect.poll(async () => Math.hypot(...((await person()).hands[0]?.force ?? [0])), kSoon).toBeGreaterThan(15);
    await touch("touchEnd");
    await expect.poll(async () => (await person()).hands, kSoon).toEqual([]);
    expect(await menu().count()).toBe(0);
  });

  it("opens the menu of a part on a long press and releases the part; a tap removes it", async () => {
    place = await find(phone, new RegExp(`^(${(await parts()).join("|")})$`), kTable);
    await touch("touchStart", place);
    await menu().waitFor(kSoon);
    await fixture.screenshot("touch-menu", phone);
    await expect.poll(async () => (await person()).hands, kSoon).toEqual([]);
    await touch("touchEnd");
    expect(await menu().count()).toBe(1);
    const part = (await menu().innerText()).replace("Take away ", "");
    await tap(menu());
    await expect.poll(async () => (await person()).absent, kSoon).toEqual([part]);
    await tap(button(`Put back ${part}`));
    await expect.poll(async () => (await person()).absent, kSoon).toEqual([]);
  });

  it("takes a long press that moves for a drag", async () => {
    const { x, y } = place;
    await touch("touchStart", { x, y });
    for (let i = 1; i <= 4; i++) await touch("touchMove", { x: x + 5 * i, y: y - 5 * i });
    await expect.poll(async () => (await person()).hands.length, kSoon).toBe(1);
    // Waits by the page's own clock, longer than a long press.
    await phone.evaluate(() => new Promise((resolve) => setTimeout(resolve, 700)));
    expect(await menu().count()).toBe(0);
    expect(await parts()).toContain((await person()).hands[0]?.body);
    await touch("touchEnd");
    await expect.poll(async () => (await person()).hands, kSoon).toEqual([]);
  });

  it("lists all parts, to take away and put back, for fingers and for keys", async () => {
    await tap(button("Parts"));
    const list = phone.getByRole("list", { name: "Parts" });
    const names = await parts();
    await expect.poll(() => list.locator("span").allInnerTexts(), kSoon).toEqual(names);
    const [first] = names;
    await tap(button(`Take away ${first}`));
    await expect.poll(async () => (await person()).absent, kSoon).toEqual([first]);
    await button(`Put back ${first}`).waitFor();
    await fixture.screenshot("touch-parts", phone);
    const box = await list.boundingBox();
    expect(box !== null && box.x >= 0 && box.x + box.width <= (phone.viewportSize()?.width ?? 0)).toBe(true);
    // The buttons above the list stay visible; the hint returns when the list is closed.
    for (const name of ["Pull", "Parts"]) {
      const tool = await button(name).boundingBox();
      expect((tool?.y ?? Infinity) + (tool?.height ?? 0), name).toBeLessThanOrEqual(box?.y ?? 0);
    }
    await expect.poll(() => phone.getByText(/^Drag the arm/).count(), kSoon).toBe(0);
    await button(`Put back ${first}`).focus();
    await phone.keyboard.press("Enter");
    await expect.poll(async () => (await person()).absent, kSoon).toEqual([]);
    await button("Parts").focus();
    await phone.keyboard.press("Enter");
    await list.waitFor({ state: "detached" });
  });
});
