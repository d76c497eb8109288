// Browser tests: the built pages in Chromium on a real server. Three files at once, as most of their time is that of the robot; then those that load would disturb, one after the other.
import { fileURLToPath } from "node:url";
import { defineConfig, type TestProjectConfiguration } from "vitest/config";

const here = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

/** What holds the arm or measures time: a page that another one keeps from its signs of life loses the controls. */
const kAlone = ["cell", "cellTools", "control", "editing", "large", "lostPage", "lostServer", "one", "ownService", "pendant", "posePreview", "remoteCell", "stop", "teachAgain", "timeline", "touch"];
const alone = kAlone.map((name) => `tests/browser/${name}.test.ts`);

const common = {
  root: here(".."),
  cacheDir: here("node_modules/.vite"),
  resolve: { alias: { jsqr: here("node_modules/jsqr/dist/jsQR.js"), "playwright-core": here("node_modules/playwright-core/index.mjs") } },
  // The tests are beside this package, not in it.
  server: { fs: { strict: false } },
};
const tests = {
  globals: true,
  testTimeout: 240_000,
  hookTimeout: 120_000,
  // What is waited for comes at once, unless the machine has much to do.
  expect: { poll: { timeout: 60_000 } },
};
// Vitest runs what has one process for all its files after the others.
const projects: TestProjectConfiguration[] = [
  { ...common, test: { ...tests, name: "beside", include: ["tests/browser/**/*.test.ts"], exclude: alone } },
  { ...common, test: { ...tests, name: "alone", include: alone, poolOptions: { forks: { singleFork: true } } } },
];

export default defineConfig({ ...common, test: { globalSetup: here("../tests/browser/chromium.ts"), maxWorkers: 3, minWorkers: 1, projects } });
