import { brotliDecompressSync, gunzipSync } from "node:zlib";
import { describe, expect, it } from "vitest";
import { compress, isCompressed } from "../../compress";

describe("compressed copies of a build", () => {
  it("are made of text and of WebAssembly, from 1 KiB on", () => {
    const names = ["pro/index.html", "assets/a.js", "assets/a.css", "assets/a.svg", "a.json", "a.wasm", "robot.urdf", "arm.stl"];
    expect(names.filter((name) => !isCompressed(name, 1024))).toEqual([]);
    expect(isCompressed("assets/a.js", 1023)).toBe(false);
  });
  it("are not made of what is compressed in itself", () => {
    expect(["inter.woff2", "photo.png", "photo.jpg", "a.js.gz", "js"].filter((name) => isCompressed(name, 100_000))).toEqual([]);
  });
  it("have the content of the file, in less bytes", async () => {
    const content = new TextEncoder().encode("let a = 1;\n".repeat(1000));
    const copies = await compress(content);
    expect([...copies.keys()]).toEqual([".br", ".gz"]);
    expect(brotliDecompressSync(copies.get(".br") ?? new Uint8Array())).toEqual(Buffer.from(content));
    expect(gunzipSync(copies.get(".gz") ?? new Uint8Array())).toEqual(Buffer.from(content));
    for (const copy of copies.values()) expect(copy.length).toBeLessThan(content.length / 10);
  });
});
