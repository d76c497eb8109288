// Compressed copies of the files of a build, which the server sends instead of them (server/http/static_files.h).
import { readFile, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { promisify } from "node:util";
import { brotliCompress, constants, gzip } from "node:zlib";
import type { Plugin } from "vite";

/** Formats that are not compressed in themselves. */
const kFormats = /\.(?:css|dae|html|js|json|map|mjs|obj|stl|svg|txt|urdf|wasm|xml)$/;

/** A smaller file is sent as it is. [bytes] */
const kLeastSize = 1024;

/** Whether a build file of this name and size [bytes] gets compressed copies. */
export const isCompressed = (name: string, size: number): boolean => kFormats.test(name) && size >= kLeastSize;

/** The copies by their endings, as small as they get: a build compresses once. */
export async function compress(content: Uint8Array): Promise<ReadonlyMap<string, Uint8Array>> {
  const { BROTLI_MAX_QUALITY, BROTLI_PARAM_QUALITY, BROTLI_PARAM_SIZE_HINT, Z_BEST_COMPRESSION } = constants;
  const params = { [BROTLI_PARAM_QUALITY]: BROTLI_MAX_QUALITY, [BROTLI_PARAM_SIZE_HINT]: content.length };
  const [br, gz] = await Promise.all([promisify(brotliCompress)(content, { params }), promisify(gzip)(content, { level: Z_BEST_COMPRESSION })]);
  return new Map([[".br", br], [".gz", gz]]);
}

/** Writes NAME.br and NAME.gz beside each file NAME of a build that gets them. */
export function compressedCopies(): Plugin {
  const writeCopies = async (folder: string, name: string): Promise<void> => {
    const content = await readFile(join(folder, name));
    if (!isCompressed(name, content.length)) return;
    for (const [ending, copy] of await compress(content)) await writeFile(join(folder, name + ending), copy);
  };
  return {
    name: "race-compressed-copies",
    apply: "build",
    writeBundle: async ({ dir = "." }, files) => {
      await Promise.all(Object.keys(files).map((name) => writeCopies(dir, name)));
    },
  };
}
