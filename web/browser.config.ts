// Browser tests: the built pages in Chromium on a real server. One after the other: each has the machine for itself.
import { fileURLToPath } from "node:url";
import { defineConfig } from "vitest/config";

const here = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

export default defineConfig({
  root: here(".."),
  cacheDir: here("node_modules/.vite"),
  resolve: { alias: { "playwright-core": here("node_modules/playwright-core/index.mjs") } },
  // The tests live beside this package, not in it.
  server: { fs: { strict: false } },
  test: { globals: true, include: ["tests/browser/**/*.test.ts"], fileParallelism: false, testTimeout: 120_000, hookTimeout: 60_000 },
});
