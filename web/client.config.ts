// Conversations of the TypeScript client with a real server (tests/client).
import { fileURLToPath } from "node:url";
import { defineConfig } from "vitest/config";

const here = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

export default defineConfig({
  root: here(".."),
  cacheDir: here("node_modules/.vite"),
  // The tests are beside this package, not in it.
  server: { fs: { strict: false } },
  test: { globals: true, include: ["tests/client/**/*.test.ts"], testTimeout: 60_000, hookTimeout: 60_000, maxWorkers: 2, minWorkers: 1 },
});
