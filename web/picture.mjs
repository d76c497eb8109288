// npm run picture -- URL FILE: a screenshot of the expert page while the demo task runs, for the README.
import { chromium } from "playwright-core";

const [url = "http://127.0.0.1:8080", file = "pro.png"] = process.argv.slice(2);
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-dev-shm-usage"],
});
try {
  const page = await browser.newPage({ viewport: { width: 1600, height: 1000 } });
  await page.goto(`${url}/pro/`);
  await page.getByRole("combobox", { name: "Document" }).selectOption("pick");
  await page.getByRole("button", { name: "Load", exact: true }).click();
  await page.getByRole("group", { name: "State Pick/Release" }).waitFor();
  await page.getByRole("toolbar", { name: "Run" }).getByRole("button", { name: "Start", exact: true }).click();
  await page.locator('.canvas [data-path="Pick/Grasp"][data-active="true"]').waitFor({ timeout: 60_000 });
  await page.waitForTimeout(400);
  await page.screenshot({ path: file });
  console.log(file);
} finally {
  await browser.close();
}
