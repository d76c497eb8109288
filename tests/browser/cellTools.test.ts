// What the 3D view adds to the bodies, on the real server: the points that the camera sees, against the bodies of the scene; where a collision was
// felt; and why an arm that is pulled holds.
import type { WebSocket } from "playwright-core";
import { cloudOf, type Cloud } from "../../web/shared/cell/cloud";
import { readStreamMessage } from "../../web/shared/messages/stream";
import type { Body } from "../../web/generated/messages";
import { openFixture, type Fixture } from "./fixture";
import { find, view } from "./pointer";
import { kSoon } from "./patience";

let fixture: Fixture;
/** The last cloud whose packet came to the page. */
let seen: Cloud | undefined;

const watch = (socket: WebSocket) =>
  socket.on("framereceived", ({ payload }) => {
    if (!String(payload).includes('{"channel":"flow/camera/frame"')) return;
    // They come together, as arrays.
    for (const { update } of (JSON.parse(String(payload)) as readonly unknown[]).map(readStreamMessage)) if (update.type === "packet") seen = cloudOf(update.packet);
  });

beforeAll(async () => {
  fixture = await openFixture();
  fixture.page.on("websocket", watch);
  await fixture.page.goto(`${fixture.url}/pro/`);
  await fixture.page.getByRole("tab", { name: "Cell" }).click();
  await view(fixture.page).waitFor(kSoon);
});
afterAll(() => fixture.close());

const tool = (name: string) => fixture.page.getByRole("button", { name });
const words = () => fixture.page.locator(".cell-collision");

async function watchers(): Promise<number | undefined> {
  const { services } = (await fixture.send("GET", "/services")) as { readonly services: readonly { readonly key: string; readonly publishes: readonly { readonly flow: string; readonly watchers: number }[] }[] };
  return services.find(({ key }) => key === "camera")?.publishes.find(({ flow }) => flow === "frame")?.watchers;
}

/** The points of a cloud that lie less than `within` [m] from a place of the table, and not on the floor, which the camera sees below its edge. */
function pointsAbove({ positions, colours, count }: Cloud, [x, y]: readonly number[], within: number) {
  const all = Array.from({ length: count }, (_, i) => ({ at: positions.subarray(3 * i, 3 * i + 3), rgb: colours.subarray(3 * i, 3 * i + 3) }));
  return all.filter(({ at }) => (at[2] ?? 0) > -0.1 && Math.hypot((at[0] ?? 0) - (x ?? 0), (at[1] ?? 0) - (y ?? 0)) < within);
}

describe("the 3D view", () => {
  it("draws what the camera sees as points where the bodies of the scene are, and fetches nothing while it does not", async () => {
    expect(await watchers()).toBe(0);
    expect(await tool("Cloud").getAttribute("aria-pressed")).toBe("false");
    await fixture.screenshot("cell-no-cloud");
    await tool("Cloud").click();
    expect(await tool("Cloud").getAttribute("aria-pressed")).toBe("true");
    const count = async () => Number.parseInt(await fixture.page.locator(".cell-hint").innerText(kSoon));
    await expect.poll(() => count(), kSoon).toBeGreaterThan(5000);
    await expect.poll(() => watchers(), kSoon).toBe(1);
    await expect.poll(() => seen?.count, kSoon).toBeGreaterThan(5000);
    if (seen === undefined) throw new Error("no packet came");
    const cloud = seen;
    const { bodies } = (await fixture.send("GET", "/cell")) as { readonly bodies: readonly Body[] };
    const body = (name: string) => bodies.find((each) => each.name === name)?.pose.position ?? [];
    await fixture.screenshot("cell-cloud");
    await tool("Cloud").click();
    await expect.poll(watchers, kSoon).toBe(0);
    await expect.poll(() => fixture.page.locator(".cell-hint").count(), kSoon).toBe(0);
    // A place of the table without a part: its points lie in its plane, but for the noise of a Kinect.
    const table = pointsAbove(cloud, [0.75, 0.25], 0.05).map(({ at }) => at[2] ?? 0);
    expect(table.length).toBeGreaterThan(20);
    expect(Math.abs(table.reduce((sum, z) => sum + z, 0) / table.length)).toBeLessThan(0.004);
    // The red cube: red points, up to its height.
    const red = pointsAbove(cloud, body("cube_red"), 0.03).filter(({ rgb }) => (rgb[0] ?? 0) > 2 * (rgb[2] ?? 0));
    expect(red.length).toBeGreaterThan(10);
    expect(Math.max(...red.map(({ at }) => at[2] ?? 0))).toBeGreaterThan(0.03);
    expect(Math.max(...red.map(({ at }) => at[2] ?? 0))).toBeLessThan(0.06);
  });

  it("marks the link at which a collision was felt, and no longer after some seconds", async () => {
    expect(await words().innerText()).toBe("");
    await fixture.send("POST", "/cell/person", { act: "push", body: "link_6", force: [0, 80, 0], duration: 0.06, rise: 0.005 });
    await expect.poll(() => words().innerText(), kSoon).toMatch(/^Collision felt at link_\d or beyond: (light|medium|severe), \d+ N if at the tool$/);
    // At the arm, not in a corner of the view.
    await expect.poll(async () => {
      const [label, whole] = [await words().boundingBox(), await view(fixture.page).boundingBox()];
      return label !== null && whole !== null && label.x > whole.x + 20 && label.y > whole.y + 20;
    }, kSoon).toBe(true);
    await fixture.screenshot("cell-collision");
    await expect.poll(() => words().innerText(), kSoon).toBe("");
  });

  it("has its tools in one row beside the task, too", async () => {
    await fixture.page.getByRole("tab", { name: "Task" }).click();
    for (const size of [{ width: 1366, height: 768 }, { width: 1600, height: 1000 }]) {
      await fixture.page.setViewportSize(size);
      await expect.poll(async () => {
        const middles: number[] = [];
        for (const name of ["Pull", "Parts", "Reset demo", "Home", "Cloud", "Close the cell view"]) {
          const box = await tool(name).boundingBox();
          middles.push(box === null ? Infinity : box.y + box.height / 2);
        }
        return Math.max(...middles) - Math.min(...middles);
      }, { ...kSoon, message: JSON.stringify(size) }).toBeLessThan(14);
    }
    await fixture.screenshot("cell-tools-docked");
    await fixture.page.getByRole("tab", { name: "Cell" }).click();
  });

  it("says at the hand why an arm that is pulled holds", async () => {
    await tool("Pull").click();
    const why = fixture.page.locator(".cell-why");
    expect(await why.innerText()).toBe("");
    const { x, y } = await find(fixture.page, /^(link_[4-7]|gripper)$/, [0.5, 0.6, 0.35, 0.5]);
    await fixture.page.mouse.down();
    await fixture.page.mouse.move(x + 40, y, { steps: 5 });
    await expect.poll(() => why.innerText(), kSoon).toMatch(/The arm holds its position: the task has not asked it to give way/);
    // At the hand, below its force.
    const force = fixture.page.locator(".cell-force").first();
    await expect.poll(async () => {
      const [reason, strength] = [await why.boundingBox(), await force.boundingBox()];
      if (reason === null || strength === null || !(await why.isVisible())) return false;
      return Math.abs(reason.y - strength.y - strength.height) < 40 && Math.abs(reason.x - strength.x) < 320;
    }, kSoon).toBe(true);
    await fixture.screenshot("cell-why");
    await fixture.page.mouse.up();
    await expect.poll(() => why.innerText(), kSoon).toBe("");
    await tool("Pull").click();
  });
});
