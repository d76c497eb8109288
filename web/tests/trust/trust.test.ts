// The page on trust: the visitor's system, the fingerprint in groups, and what the server says of its authority.
import { describe, expect, it } from "vitest";
import { askAuthority } from "../../shared/trust/authority";
import { fingerprintGroups } from "../../shared/trust/fingerprint";
import { firstSystem, systemInHash, systemOf } from "../../shared/trust/system";
import { trustAddress } from "../../shared/trust/trustAddress";

const kMac = "Mozilla/5.0 (Macintosh; Intel Mac OS X 10_15_7) AppleWebKit/605.1.15 (KHTML, like Gecko) Version/18.1 Safari/605.1.15";
const kAndroid = "Mozilla/5.0 (Linux; Android 14; Pixel 8) AppleWebKit/537.36 (KHTML, like Gecko) Chrome/130.0.0.0 Mobile Safari/537.36";
const kIphone = "Mozilla/5.0 (iPhone; CPU iPhone OS 18_1 like Mac OS X) AppleWebKit/605.1.15 (KHTML, like Gecko) Version/18.1 Mobile/15E148 Safari/604.1";
const kWindows = "Mozilla/5.0 (Windows NT 10.0; Win64; x64) AppleWebKit/537.36 (KHTML, like Gecko) Chrome/130.0.0.0 Safari/537.36 Edg/130.0.0.0";
const kLinux = "Mozilla/5.0 (X11; Linux x86_64; rv:132.0) Gecko/20100101 Firefox/132.0";

describe("the visitor's system", () => {
  const of = (userAgent: string, maxTouchPoints = 0) => systemOf({ userAgent, maxTouchPoints });

  it("is known by the browser", () => {
    expect([of(kAndroid, 5), of(kIphone, 5), of(kWindows), of(kMac), of(kLinux)]).toEqual(["android", "apple", "windows", "macos", "linux"]);
    expect(of(kWindows, 10), "with a touch screen").toBe("windows");
    expect(of("curl/8.5.0")).toBeUndefined();
  });
  it("is an iPad if a Mac has a touch screen", () => {
    expect(of(kMac, 5)).toBe("apple");
  });
  it("is the one that the address names, before that of the visitor", () => {
    expect([systemInHash("#linux"), systemInHash("#bogus"), systemInHash("")]).toEqual(["linux", undefined, undefined]);
    const visitor = { userAgent: kAndroid, maxTouchPoints: 5 };
    expect([firstSystem("#windows", visitor), firstSystem("#bogus", visitor), firstSystem("", { userAgent: "", maxTouchPoints: 0 })]).toEqual(["windows", "android", undefined]);
  });
});

const kPairs = Array.from({ length: 32 }, (_, i) => (i + 160).toString(16).toUpperCase());

describe("a fingerprint", () => {
  it("has eight groups of four pairs", () => {
    const groups = fingerprintGroups(kPairs.join(":"));
    expect(groups).toHaveLength(8);
    expect(groups?.[0]).toBe("A0:A1:A2:A3");
    expect(groups?.join(":")).toBe(kPairs.join(":"));
    expect(fingerprintGroups(kPairs.join(":").toLowerCase())).toEqual(groups);
  });
  it("is none if it is no SHA-256", () => {
    expect([null, "", "A0:A1", kPairs.slice(1).join(":"), `${kPairs.slice(1).join(":")}:GG`].map(fingerprintGroups)).toEqual(Array(5).fill(undefined));
  });
});

describe("the authority of the server", () => {
  const asked = (answer: () => Response) => askAuthority("/api/v1", () => Promise.resolve(answer()));
  const kHeaders = { "x-fingerprint-sha256": kPairs.join(":") };

  it("is there, with its fingerprint", async () => {
    expect(await asked(() => new Response("PEM", { headers: kHeaders }))).toMatchObject({ kind: "there" });
  });
  it("is not there on a server without a network", async () => {
    expect(await asked(() => new Response("{}", { status: 404 }))).toEqual({ kind: "none" });
  });
  it("is lost with the server, or without a fingerprint", async () => {
    expect(await askAuthority("/api/v1", () => Promise.reject(new TypeError("Failed to fetch")))).toEqual({ kind: "lost" });
    expect(await asked(() => new Response("PEM"))).toEqual({ kind: "lost" });
    expect(await asked(() => new Response("{}", { status: 503, headers: kHeaders }))).toEqual({ kind: "lost" });
  });
});

describe("the way to the page", () => {
  it("is shown where the page came over TLS", () => {
    expect([trustAddress({ protocol: "https:" }), trustAddress({ protocol: "http:" })]).toEqual(["/trust/", undefined]);
  });
});
