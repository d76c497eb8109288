// What the server says of its certificate authority.
import { fingerprintGroups } from "./fingerprint";

export type Authority =
  | { readonly kind: "there"; readonly fingerprint: readonly string[] }
  /** The server serves no network. */
  | { readonly kind: "none" }
  /** It does not answer, or not as it should. */
  | { readonly kind: "lost" };

export async function askAuthority(base: string, fetcher: typeof fetch): Promise<Authority> {
  try {
    const answer = await fetcher(`${base}/authority`, { method: "GET", cache: "no-store" });
    if (answer.status === 404) return { kind: "none" };
    const fingerprint = answer.ok ? fingerprintGroups(answer.headers.get("x-fingerprint-sha256")) : undefined;
    return fingerprint === undefined ? { kind: "lost" } : { kind: "there", fingerprint };
  } catch {
    return { kind: "lost" };
  }
}
