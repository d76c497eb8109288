import { describe, expect, it } from "vitest";
import { addressWith, placeOfAddress } from "../../shared/session/address";

describe("the address", () => {
  it("names the run and the document, and keeps what else it says", () => {
    expect(placeOfAddress(addressWith("", { run: "7" }))).toEqual({ run: "7" });
    expect(addressWith("?lang=en&run=7", { run: "8", edit: "pick" })).toBe("?lang=en&run=8&edit=pick");
    expect(addressWith("?run=8&edit=pick", { edit: undefined })).toBe("?run=8");
    expect(addressWith("?run=8", { at: "12.3" })).toBe("?run=8&at=12.3");
    expect(placeOfAddress("?run=8&at=12.3&runs=1")).toEqual({ run: "8", at: "12.3", runs: "1" });
    expect(placeOfAddress("")).toEqual({});
  });
});
