// Build of the browser pages: one package, one entry per page, output in web/dist (served by the server at `/`).
import { resolve } from "node:path";
import react from "@vitejs/plugin-react";
import { defineConfig } from "vite";

/** Where `npm run dev` finds a running server; the built pages always talk to the server they came from. */
const server = process.env["RACE_SERVER"] ?? "http://127.0.0.1:8080";

export default defineConfig({
  root: import.meta.dirname,
  plugins: [react()],
  worker: { format: "es" },
  build: {
    outDir: "dist",
    emptyOutDir: true,
    target: "es2022",
    chunkSizeWarningLimit: 1600,
    rollupOptions: {
      input: {
        index: resolve(import.meta.dirname, "index.html"),
        pro: resolve(import.meta.dirname, "pro/index.html"),
      },
    },
  },
  server: { proxy: { "/api": { target: server, ws: true, changeOrigin: true } } },
});
