// Data flows on the expert page, on the real server: publishers, subscribers, and the camera's picture while it is watched.
import { openFixture, type Fixture } from "./fixture";
import { kSoon } from "./patience";

let fixture: Fixture;

beforeAll(async () => {
  fixture = await openFixture();
  await fixture.page.setViewportSize({ width: 1280, height: 800 });
  await fixture.page.goto(`${fixture.url}/pro/`);
  await fixture.page.getByRole("tab", { name: /Services/ }).click();
  await edge().waitFor();
});
afterAll(() => fixture.close());

const edge = () => fixture.page.locator('[data-flow="camera.frame:obj_rec"]');
const opener = (flow = "frame") => fixture.page.getByRole("button", { name: `Watch camera.${flow}` });
const panel = (flow = "frame") => fixture.page.getByRole("region", { name: `Packets of camera.${flow}` });
const canvas = () => panel().locator("canvas");

interface Published {
  readonly flow: string;
  readonly watchers: number;
  readonly rate_hz: number;
}
async function frame(): Promise<Published | undefined> {
  const { services } = (await (await fetch(`${fixture.url}/api/v1/services`)).json()) as { readonly services: readonly { readonly key: string; readonly publishes: readonly Published[] }[] };
  return services.find(({ key }) => key === "camera")?.publishes[0];
}
const idle = () => expect.poll(frame, kSoon).toEqual({ flow: "frame", watchers: 0, rate_hz: 0 });

async function post(path: string, body?: unknown, method = "POST"): Promise<{ readonly id: string }> {
  const answer = await fetch(`${fixture.url}/api/v1${path}`, { method, body: body === undefined ? null : JSON.stringify(body), headers: { "content-type": "application/json" } });
  if (!answer.ok) throw new Error(`${path}: ${answer.status} ${await answer.text()}`);
  return (await answer.json()) as { readonly id: string };
}

/** Every eighth pixel of the picture: red, green and blue as one number. */
const pixels = () =>
  canvas().evaluate((element: HTMLCanvasElement) => {
    const data = element.getContext("2d")?.getImageData(0, 0, element.width, element.height).data ?? [];
    return Array.from({ length: data.length / 32 }, (_, i) => ((data[32 * i] ?? 0) << 16) | ((data[32 * i + 1] ?? 0) << 8) | (data[32 * i + 2] ?? 0));
  });
const coloursOf = (picture: readonly number[]) => new Set(picture).size;
/** The share of pixels that are clearly of another colour: far beyond the noise of the camera. */
function difference(a: readonly number[], b: readonly number[]): number {
  const apart = (x: number, y: number) => [16, 8, 0].reduce((sum, shift) => sum + Math.abs(((x >> shift) & 255) - ((y >> shift) & 255)), 0);
  return a.filter((colour, i) => apart(colour, b[i] ?? 0) > 60).length / a.length;
}

describe("data flows", () => {
  it("lead from the camera to recognition, and are idle when nobody subscribes", async () => {
    expect(await edge().locator("text").textContent()).toBe("frame");
    expect(await edge().getAttribute("class")).toBe("flow");
    await expect.poll(() => fixture.page.getByRole("img", { name: /camera publishes frame to obj_rec, no packets now/ }).count()).toBe(1);
    await idle();
    await fixture.screenshot("flows-idle");
  });

  it("are thick, with their rate, while a run uses recognition", async () => {
    const root = { state: "Root", entry: "svc.obj_rec.start()", exit: "svc.obj_rec.stop()", ports: [{ name: "never", when: "svc.timer.elapsed" }] };
    await post("/documents/seeing", { rcm: 1, name: "seeing", root }, "PUT");
    const core = await post("/cores", { document: "seeing", arguments: {} });
    await post(`/cores/${core.id}/start`);
    await expect.poll(() => edge().getAttribute("class"), kSoon).toBe("flow is-flowing");
    await expect.poll(() => edge().locator("text").textContent(), kSoon).toMatch(/^frame \d+\.\d\/s$/);
    await fixture.screenshot("flows-flowing");
    await post(`/cores/${core.id}/stop`);
    await expect.poll(() => edge().getAttribute("class"), kSoon).toBe("flow");
    await idle();
  });

  it("show the camera's picture by the keyboard, in colour and in depth", async () => {
    await opener().focus();
    await fixture.page.keyboard.press("Enter");
    await canvas().waitFor();
    await expect.poll(async () => coloursOf(await pixels()), kSoon).toBeGreaterThan(1000);
    const colour = await pixels();
    await expect.poll(() => panel().locator("footer").innerText(), kSoon).toMatch(/^\d+\.\d\d s\s+\d+\.\d packets\/s of world time$/);
    await fixture.screenshot("flows-colour");
    await panel().getByRole("radio", { name: "Colour" }).focus();
    await fixture.page.keyboard.press("ArrowRight");
    await expect.poll(async () => difference(colour, await pixels()), kSoon).toBeGreaterThan(0.5);
    expect(coloursOf(await pixels())).toBeGreaterThan(100);
    await fixture.screenshot("flows-depth");
    await fixture.page.keyboard.press("ArrowLeft");
    await expect.poll(async () => difference(colour, await pixels()), kSoon).toBeLessThan(0.1);
  });

  it("show the header of packets without a picture, and offer neither colour nor depth", async () => {
    const says = { frame: /depth and colour of 640x480 pixels/, cloud: /points that were measured/ };
    for (const [flow, text] of Object.entries(says)) expect(await fixture.page.locator(".data-flows li").filter({ has: opener(flow) }).innerText()).toMatch(text);
    await opener("cloud").click();
    await expect.poll(() => panel("cloud").getByLabel("Newest packet").innerText(), kSoon).toMatch(/points\s+\d{4,}[^]*encoding\s+'xyz32f_m\+rgb8'/);
    expect(await panel("cloud").locator("canvas, input").count()).toBe(0);
    await fixture.screenshot("flows-cloud");
    await opener().click();
    await canvas().waitFor();
    await expect.poll(() => panel().getByRole("radio").count()).toBe(2);
  });

  it("update the picture, and fit a window of 1280x800", async () => {
    const time = async () => Number.parseFloat(await panel().locator(".flow-time").innerText());
    const before = await time();
    await expect.poll(time, kSoon).toBeGreaterThan(before + 1);
    const box = await canvas().boundingBox();
    expect((box?.y ?? 800) + (box?.height ?? 0)).toBeLessThan(800);
    expect(await fixture.page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(1280);
  });

  it("stop when the picture is closed by key or click, or another tab is opened", async () => {
    await fixture.page.keyboard.press("Escape");
    await expect.poll(() => panel().count()).toBe(0);
    await expect.poll(() => opener().evaluate((element) => element === document.activeElement)).toBe(true);
    await idle();
    await opener().click();
    await canvas().waitFor();
    await panel().getByRole("button", { name: "Stop watching camera.frame" }).click();
    await idle();
    await opener().click();
    await canvas().waitFor();
    await fixture.page.getByRole("tab", { name: "Task" }).click();
    await idle();
  });
});
