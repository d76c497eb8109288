import { describe, expect, it } from "vitest";
import { stopAddresses } from "../../shared/stop/addresses";

const ports = [{ port: 8080, stop_port: 41207 }, { port: 443, stop_port: 41208 }];

describe("a stop goes", () => {
  it("to the port of its own, and to the ordinary one", () => {
    expect(stopAddresses({ protocol: "http:", hostname: "127.0.0.1", port: "8080" }, ports)).toEqual(["http://127.0.0.1:41207/api/v1/stop", "/api/v1/stop"]);
  });
  it("to that of the usual port, if the address of the page has none", () => {
    expect(stopAddresses({ protocol: "https:", hostname: "cell.local", port: "" }, ports)[0]).toBe("https://cell.local:41208/api/v1/stop");
    expect(stopAddresses({ protocol: "http:", hostname: "cell.local", port: "" }, ports)).toEqual(["/api/v1/stop"]);
  });
  it("to the ordinary one alone, if no other is known, or at an IPv6 address", () => {
    expect(stopAddresses({ protocol: "http:", hostname: "127.0.0.1", port: "5173" }, ports)).toEqual(["/api/v1/stop"]);
    expect(stopAddresses({ protocol: "http:", hostname: "[::1]", port: "8080" }, ports)).toEqual(["/api/v1/stop"]);
  });
});
