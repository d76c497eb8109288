// The size of what a page needs before it can show anything: the scripts and styles that its HTML names, compressed as they are sent.
import { existsSync, readFileSync, statSync } from "node:fs";
import { join } from "node:path";

export interface BundleSize {
  readonly files: readonly string[];
  /** [byte] */
  readonly gzip: number;
  readonly brotli: number;
}

/** Of a page in `dist`, a folder that was built, by the path of its HTML. */
export function bundleSize(dist: string, html: string): BundleSize {
  const text = readFileSync(join(dist, html), "utf8");
  const files = [...text.matchAll(/<(?:script|link)[^>]*(?:src|href)="\/(assets\/[^"]+\.(?:js|css))"/g)].map(([, file]) => file ?? "");
  if (files.length === 0) throw new Error(`${html} names no scripts: is the build complete?`);
  // What is small has no compressed copy (web/compress.ts) and is sent as it is.
  const sent = (file: string, extension: string) => (existsSync(join(dist, file + extension)) ? file + extension : file);
  const sum = (extension: string) => files.reduce((bytes, file) => bytes + statSync(join(dist, sent(file, extension))).size, 0);
  return { files, gzip: sum(".gz"), brotli: sum(".br") };
}
