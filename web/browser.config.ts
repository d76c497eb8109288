// Browser tests: the built pages in Chromium on a real server. Two files run at once, then, one after the other, those that
// a busy machine would fail: they measure, or hold the controls of the cell, which a page loses that is silent for 250 ms.
import { fileURLToPath } from "node:url";
import { defineConfig } from "vitest/config";

const here = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

const tests = "tests/browser/**/*.test.ts";
const alone = ["control", "firstUse", "large", "lostPage", "moving", "one", "pairing", "pendant", "posePreview", "speed", "stop"].map((name) => `tests/browser/${name}.test.ts`);

export default defineConfig({
  root: here(".."),
  cacheDir: here("node_modules/.vite"),
  resolve: { alias: { jsqr: here("node_modules/jsqr/dist/jsQR.js"), "playwright-core": here("node_modules/playwright-core/index.mjs") } },
  // The tests are beside this package, not in it.
  server: { fs: { strict: false } },
  test: {
    globals: true,
    globalSetup: here("../tests/browser/chromium.ts"),
    maxWorkers: 2,
    projects: [
      { extends: true, test: { name: "beside", include: [tests], exclude: alone } },
      { extends: true, test: { name: "alone", include: alone, poolOptions: { forks: { singleFork: true } } } },
    ],
    testTimeout: 120_000,
    hookTimeout: 60_000,
    // What is waited for comes at once, unless the machine has much to do.
    expect: { poll: { timeout: 15_000 } },
  },
});
