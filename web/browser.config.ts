// Browser tests: the built pages in Chromium on a real server. They run one after the other, as they are sensitive to load.
import { fileURLToPath } from "node:url";
import { defineConfig } from "vitest/config";

const here = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

export default defineConfig({
  root: here(".."),
  cacheDir: here("node_modules/.vite"),
  resolve: { alias: { jsqr: here("node_modules/jsqr/dist/jsQR.js"), "playwright-core": here("node_modules/playwright-core/index.mjs") } },
  // The tests are beside this package, not in it.
  server: { fs: { strict: false } },
  test: {
    globals: true,
    globalSetup: here("../tests/browser/chromium.ts"),
    include: ["tests/browser/**/*.test.ts"],
    fileParallelism: false,
    testTimeout: 120_000,
    hookTimeout: 60_000,
    // What is waited for comes at once, unless the machine has much to do.
    expect: { poll: { timeout: 15_000 } },
  },
});
