import { describe, expect, it } from "vitest";
import { codeOf, displayAddress, isDisplayName, networkChoice, notPairedText, pairing } from "../../shared/display/pairing";

import { RaceError } from "../../shared/api";

describe("a phone that is not paired", () => {
  const refused = (status: number, code: string, message: string, retryAfter?: number) => new RaceError(status, [{ path: "", code, message }], { retryAfter });
  it("says why in plain words, and what to do", () => {
    const used = notPairedText(refused(401, "pairing", "the code is wrong"));
    expect(used).toBe("This phone is not paired: the code was used already, or it is too old. Press “New code” on the page that shows it, and scan that code within a minute.");
    expect(notPairedText(refused(429, "too_many", "slowly", 7))).toContain("Wait 7 s, then press “New code”");
    expect(notPairedText(refused(507, "storage", "the disk is full"))).toContain("not paired: the disk is full. Press “New code”");
    expect(notPairedText(new TypeError("Failed to fetch"))).toContain("the server does not answer. Connect the phone to the network of the server");
  });
});

describe("pairing a phone", () => {
  it("leads through a tunnel to a server that answers its own machine alone, at the same port", () => {
    for (const hostname of ["localhost", "127.0.0.1", "[::1]"]) {
      expect(pairing({ protocol: "http:", hostname, port: "8123" }, { name: "left" })).toEqual({
        address: "http://localhost:8123/display/?name=left",
        tunnel: { usb: "adb reverse tcp:8123 tcp:8123", ssh: "ssh -L 8123:127.0.0.1:8123 USER@THIS_MACHINE" },
      });
    }
    expect(pairing({ protocol: "http:", hostname: "localhost", port: "" }, { name: "x" }).tunnel?.usb).toBe("adb reverse tcp:80 tcp:80");
  });
  it("is the address, and what to trust before, where the page came from another machine", () => {
    expect(pairing({ protocol: "https:", hostname: "cell.example", port: "" }, { name: "phone" })).toEqual({ address: "https://cell.example/display/?name=phone", trust: "https://cell.example/trust/" });
    expect(pairing({ protocol: "http:", hostname: "cell.example", port: "8080" }, { name: "phone" })).toEqual({ address: "http://cell.example:8080/display/?name=phone" });
  });
  it("leads to the network of the server, if it serves one, also from a page of its own machine", () => {
    expect(pairing({ protocol: "http:", hostname: "127.0.0.1", port: "8080" }, { name: "left" }, "https://192.168.1.5:8443")).toEqual({
      address: "https://192.168.1.5:8443/display/?name=left",
      trust: "https://192.168.1.5:8443/trust/",
    });
  });
  it("leaves the choice of the network to the person at the server, where there are several", () => {
    const networks = ["https://192.168.1.5:8443", "https://10.0.0.7:8443"];
    const page = { protocol: "http:", hostname: "127.0.0.1", port: "8080" };
    expect(networkChoice(page, networks)).toEqual(networks);
    expect(networkChoice(page, networks.slice(1)), "one is no choice").toEqual([]);
    expect(networkChoice({ ...page, hostname: "10.0.0.7" }, networks), "the page came that way").toEqual([]);
  });
  it("has the place of the display, and the code where no server is told of it", () => {
    const code = "abcdefghijkl-_01234567";
    const address = displayAddress("https://cell.example", { name: "left", place: "gripper", code });
    expect(address).toBe(`https://cell.example/display/?name=left&place=gripper#code=${code}`);
    expect(codeOf(new URL(address).hash)).toBe(code);
  });
  it.each(["", "#move", "#code=", "#code=short", `#code=${"x".repeat(23)}`, `#code=${"x".repeat(21)} `])("is no code: `%s`", (hash) => {
    expect(codeOf(hash)).toBeUndefined();
  });
  it("takes the names of displays", () => {
    expect(["phone", "a-B_9", "all", "", "ä", "x".repeat(33), "a b", "a&b"].map(isDisplayName)).toEqual([true, true, false, false, false, false, false, false]);
  });
});
