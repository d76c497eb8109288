import { describe, expect, it } from "vitest";
import { isDisplayName, pairing } from "../../shared/display/pairing";

describe("pairing a phone", () => {
  it("leads through a tunnel to a server that answers its own machine alone, at the same port", () => {
    for (const hostname of ["localhost", "127.0.0.1", "[::1]"]) {
      expect(pairing({ protocol: "http:", hostname, port: "8123" }, "left")).toEqual({
        address: "http://localhost:8123/display/?name=left",
        tunnel: { usb: "adb reverse tcp:8123 tcp:8123", ssh: "ssh -L 8123:127.0.0.1:8123 USER@THIS_MACHINE" },
      });
    }
    expect(pairing({ protocol: "http:", hostname: "localhost", port: "" }, "x").tunnel?.usb).toBe("adb reverse tcp:80 tcp:80");
  });
  it("is the address, and what to trust before, where the page came from another machine", () => {
    expect(pairing({ protocol: "https:", hostname: "cell.example", port: "" }, "phone")).toEqual({ address: "https://cell.example/display/?name=phone", trust: "https://cell.example/trust/" });
    expect(pairing({ protocol: "http:", hostname: "cell.example", port: "8080" }, "phone")).toEqual({ address: "http://cell.example:8080/display/?name=phone" });
  });
  it("takes the names of displays", () => {
    expect(["phone", "a-B_9", "all", "", "ä", "x".repeat(33), "a b", "a&b"].map(isDisplayName)).toEqual([true, true, false, false, false, false, false, false]);
  });
});
