// The speed of the robot outlives who has set it: each page says that it is not the whole, and what to do where the robot stands for that.
import { devices, type Locator, type Page } from "playwright-core";
import { watchArm, type Arm } from "./arm";
import { findings } from "./axe";
import { tap } from "./fingers";
import { openFixture, type Fixture } from "./fixture";
import { holding } from "./prepare";
import { kPatience, kSoon } from "./patience";

let fixture: Fixture;
let arm: Arm;
let phone: Page;
let one: Page;
let pro: Page;

const kStart = [0, -0.35, 0, 1.6, 0, -1.19, 0];
const turn = (state: string, other: string, base: number) => ({ state, entry: `svc.robot.move({'joints': [${[base, ...kStart.slice(1)].join(", ")}]}, speed=0.2)`, ports: [{ name: "next", when: "svc.robot.move.result", to: other }] });

beforeAll(async () => {
  fixture = await openFixture();
  arm = watchArm(fixture.url);
  await fixture.send("PUT", "/documents/toAndFro", { rcm: 1, name: "toAndFro", root: { state: "Root", first: "Left", children: [turn("Left", "Right", 0.6), turn("Right", "Left", -0.6)] } });
  phone = await (await fixture.openContext({ ...devices["Pixel 7"], reducedMotion: "reduce" })).newPage();
  one = await (await fixture.openContext({ viewport: { width: 1024, height: 768 }, reducedMotion: "reduce" })).newPage();
  pro = fixture.page;
  for (const page of [phone, one, pro]) page.setDefaultTimeout(kPatience);
  await phone.goto(`${fixture.url}/display/?name=phone1#run`);
  await one.goto(`${fixture.url}/one/?edit=toAndFro#run`);
  await pro.goto(`${fixture.url}/pro/`);
  await pro.getByText("Connected", { exact: true }).waitFor();
});
afterAll(async () => {
  arm.close();
  await fixture.close();
});

const moves = (wanted: boolean) => expect.poll(arm.moves, kSoon).toBe(wanted);
const sign = (of: Page) => of.getByRole("region", { name: "Controls of the cell" }).locator(".speed-sign > p");
const slider = (of: Page) => of.getByRole("slider", { name: "Robot speed" });
const everywhere = async (text: RegExp) => {
  for (const page of [phone, one, pro]) await sign(page).filter({ hasText: text }).waitFor();
};
const nowhere = async () => {
  for (const page of [phone, one, pro]) await sign(page).waitFor({ state: "detached" });
};
/** Does it with the controls, which are given back then. */
async function withControls(of: Page, press: (on: Locator) => Promise<unknown>, act: () => Promise<unknown>): Promise<void> {
  const mark = of.getByText("You have the controls", { exact: true });
  const take = async () => {
    if (await mark.isVisible()) return;
    await press(of.getByRole("button", { name: "Take the controls" }));
    await mark.waitFor();
  };
  await holding(take, mark, act);
  await holding(take, mark, () => press(of.getByRole("button", { name: "Give back" })));
  await of.getByText("Nobody has the controls").waitFor();
}
const kPress = { timeout: 5000 };
const click = (on: Locator) => on.click(kPress);
const overflow = (of: Page) => of.evaluate(() => document.documentElement.scrollWidth - innerWidth);

describe("the speed of the robot", () => {
  it("is not said while it is the whole", async () => {
    await tap(phone.getByRole("button", { name: "Start toAndFro" }));
    await moves(true);
    await nowhere();
  });

  it("can be set where runs are, also while it is the whole", async () => {
    for (const page of [phone, one]) await expect.poll(() => slider(page).inputValue(), kSoon).toBe("1");
    await pro.goto(`${fixture.url}/pro/?below=manual`);
    await slider(pro).waitFor();
    await expect.poll(() => slider(pro).inputValue(), kSoon).toBe("1");
    await pro.goto(`${fixture.url}/pro/`);
  });

  it("is said on all pages when it is less, also when who has set it has given the controls back", async () => {
    await withControls(phone, tap, async () => {
      await slider(phone).fill("0.2", kPress);
      await everywhere(/^Speed: 20 % The robot goes slower than its tasks say/);
    });
    await phone.reload();
    await one.reload();
    await everywhere(/^Speed: 20 %/);
    await fixture.screenshot("speed-one", one);
    await fixture.screenshot("speed-phone", phone);
    await expect.poll(async () => [await overflow(phone), await overflow(one), await overflow(pro)], kSoon).toEqual([0, 0, 0]);
  });

  it("is said unmistakably when the robot stands for it, and what to do", async () => {
    await withControls(phone, tap, async () => {
      await slider(phone).fill("0", kPress);
      await moves(false);
    });
    await everywhere(/^Speed: 0 % The robot stands still, and a task that moves it waits\. Set a higher speed (here|under Run), and it goes on\.$/);
    await expect.poll(() => sign(one).getAttribute("role"), kSoon).toBe("alert");
    await fixture.screenshot("speed-zero-one", one);
    await fixture.screenshot("speed-zero-phone", phone);
    await fixture.screenshot("speed-zero-pro", pro);
    expect([await findings(one), await findings(pro)]).toEqual([[], []]);
    await one.getByText(/^To change it: /).waitFor();
  });

  it("is set where it is said, by who has the controls; then the run goes on", async () => {
    await withControls(one, click, async () => {
      await slider(one).fill("0.5", kPress);
      await moves(true);
      await everywhere(/^Speed: 50 %/);
      await slider(one).fill("1", kPress);
      await nowhere();
    });
  });

  it("is asked for a few times in all", async () => {
    let asked = 0;
    one.on("request", (request) => (asked += request.url().endsWith("/services/robot/calls") ? 1 : 0));
    await one.reload();
    await one.getByText("Nobody has the controls").waitFor();
    await moves(true);
    await one.waitForTimeout(4000);
    expect(asked).toBeGreaterThan(0);
    expect(asked).toBeLessThanOrEqual(4);
  });
});
