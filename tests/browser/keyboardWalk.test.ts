// From the list of documents to the end of a run without a mouse. After each key that opens, closes or does something, the focus is somewhere, and seen.
import { openFixture, settled, type Fixture } from "./fixture";
import { heard, keyboard } from "./hands";
import { kPatience } from "./patience";

let fixture: Fixture;
const kLift = {
  rcm: 1,
  root: {
    state: "Root", first: "Lift",
    children: [
      { state: "Lift", first: "Up", children: [{ state: "Up", entry: 'svc.robot.move({"offset": [0, 0, 0.01]})', ports: [{ name: "done", when: "svc.robot.move.result" }] }], ports: [{ name: "done", when: "chi.Up.port.done" }] },
    ],
  },
};
beforeAll(async () => {
  fixture = await openFixture();
  fixture.page.setDefaultTimeout(kPatience);
  await fixture.page.setViewportSize({ width: 1366, height: 768 });
  await fixture.send("PUT", "/documents/lift", kLift);
  await fixture.page.goto(`${fixture.url}/pro/`);
  await fixture.page.getByText("Connected").waitFor();
});
afterAll(() => fixture.close());

const stored = async () => JSON.stringify(await fixture.send("GET", "/documents/lift"));
const status = () => fixture.page.getByRole("status", { name: "Run status" }).innerText();

/** What is wrong with the focus: it is nowhere, or not seen. */
const focus = () =>
  fixture.page.evaluate(() => {
    const at = document.activeElement;
    if (at === null || at === document.body) return "nowhere";
    const inside = at.closest(".cm-editor, .edit-canvas") ?? at;
    const box = inside.getBoundingClientRect();
    const isSeen = [at, inside].some((each) => getComputedStyle(each).outlineStyle !== "none" || getComputedStyle(each).boxShadow !== "none");
    return box.width > 0 && box.height > 0 && isSeen ? "seen" : `not seen: ${at.outerHTML.slice(0, 120)}`;
  });
const kept = (after: string) => expect.poll(focus, { message: after }).toBe("seen");

it("a document is opened, edited and closed", async () => {
  const { page } = fixture;
  const { keys, go } = keyboard(page);
  await keys("Control+o");
  await page.getByRole("dialog", { name: "Documents" }).waitFor();
  await keys("Escape");
  await go("Documents");
  await keys("Enter");
  await page.getByRole("dialog", { name: "Documents" }).waitFor();
  await keys("Escape");
  await expect.poll(() => heard(page)).toBe("Documents");
  await keys("Enter");
  await expect.poll(() => heard(page)).toBe("Search the documents");
  await page.keyboard.type("lift");
  await kept("search");
  await keys("Enter");
  await settled(page);
  await kept("the document is open");
  await go("Drawing of lift");
  await kept("the drawing");
  await keys("ArrowDown");
  await expect.poll(() => page.locator("#edit-canvas .is-selected").first().getAttribute("aria-label")).toContain("Root/Lift");
  await keys("Control+Enter");
  await page.locator("#edit-canvas [data-path='Root/Lift/Up']").waitFor();
  await settled(page);
  await kept("a state was entered");
  await keys("ArrowDown");
  await keys("Alt+s");
  await page.locator("#edit-canvas [data-path='Root/Lift/State']").waitFor();
  await kept("a state was added");
  await keys("F2");
  await page.keyboard.type("Hold");
  await kept("its name is written");
  await keys("Enter");
  await page.locator("#edit-canvas [data-path='Root/Lift/Hold']").waitFor();
  await kept("it was renamed");
  await keys("ArrowLeft", "Shift+ArrowDown", "Control+l");
  await page.getByRole("menu", { name: "Connect to" }).waitFor();
  await kept("the menu");
  while (!(await heard(page)).includes("Hold")) await keys("H");
  await keys("Enter");
  await expect.poll(stored).toContain('"to":"Hold"');
  await kept("the port was led to it");
});

it("a run of it is started after the question, paused, stepped, looked at in the past, and stopped", async () => {
  const { page } = fixture;
  const { keys, go } = keyboard(page);
  await keys("F5");
  await expect.poll(status).toContain("Ready");
  await settled(page);
  await kept("the run was made");
  await go("Start");
  await keys("Enter");
  const question = page.getByRole("alertdialog", { name: "Before it moves" });
  /** What is pressed then answers the question. */
  const isAsked = () => question.evaluate((dialog) => dialog.contains(document.activeElement));
  await expect.poll(isAsked).toBe(true);
  await kept("the question");
  await keys("Escape");
  await question.waitFor({ state: "detached" });
  await expect.poll(() => heard(page)).toBe("Start");
  await keys("Enter");
  await expect.poll(isAsked).toBe(true);
  await keys("Enter");
  await expect.poll(status).toContain("Running");
  await kept("the run goes on");
  await go("Pause");
  await keys("Enter");
  await expect.poll(status).toContain("Paused");
  await kept("it is paused");
  await go("Macro step");
  await keys("Enter");
  await kept("a step");
  await keys("F9");
  await page.getByRole("button", { name: "Now", exact: true }).waitFor();
  await kept("the past");
  await go("Derivation");
  await keys("Enter");
  await page.getByRole("region", { name: "Derivation" }).waitFor();
  await go("Calls and events");
  await keys("Enter");
  await kept("another panel");
  await keys("Enter");
  await expect.poll(() => page.locator(".drawer").count()).toBe(0);
  await kept("the panel is closed");
  await keys("Escape");
  await kept("the present");
  await go("Stop", "Shift+Tab");
  await keys("Enter");
  await expect.poll(status).toContain("Stopped");
  await kept("it is stopped");
  await keys("?");
  await page.getByRole("dialog", { name: "Keys and mouse" }).waitFor();
  await kept("the keys");
  await keys("Escape");
  await kept("the keys are closed");
});
