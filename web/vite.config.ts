// Build of the browser pages: one package, one entry per page, output in web/dist (served by the server at `/`).
import { fileURLToPath } from "node:url";
import react from "@vitejs/plugin-react";
import { defineConfig } from "vitest/config";
import { compressedCopies } from "./compress";

/** Where `npm run dev` finds a running server; the built pages always talk to the server they came from. */
const server = process.env["RACE_SERVER"] ?? "http://127.0.0.1:8080";

const here = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

export default defineConfig({
  root: here("."),
  plugins: [react(), compressedCopies()],
  worker: { format: "es" },
  build: {
    outDir: "dist",
    emptyOutDir: true,
    target: "es2022",
    chunkSizeWarningLimit: 1600,
    rollupOptions: {
      input: {
        index: here("index.html"),
        pro: here("pro/index.html"),
        one: here("one/index.html"),
        display: here("display/index.html"),
        trust: here("trust/index.html"),
        sw: here("display/sw.ts"),
      },
      // A service worker serves what is below its own address.
      output: { entryFileNames: ({ name }) => (name === "sw" ? "display/sw.js" : "assets/[name]-[hash].js") },
    },
  },
  // A loaded machine may be slow, and no test measures time.
  test: { include: ["tests/**/*.test.ts"], testTimeout: 60_000 },
  // The list of sounds is in api/.
  server: { fs: { allow: [here("."), here("../api")] }, proxy: { "/api": { target: server, ws: true, changeOrigin: true } } },
});
