// The schemas of api/ can be read apart from their folder: each has an address, and refers to others by it.
import { readdirSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { describe, expect, it } from "vitest";
import { readJson } from "../files";
import { compile } from "../schemas";

const folder = new URL("../../../api/schemas/", import.meta.url);

describe("api/schemas", () => {
  it.each(readdirSync(fileURLToPath(folder)))("%s has the address of its file, and finds what it refers to", (file) => {
    const $id = `https://race.invalid/schemas/${file}`;
    expect(readJson(new URL(file, folder))).toMatchObject({ $id });
    expect(compile<unknown>({ $ref: $id })).toBeTypeOf("function");
  });
});
