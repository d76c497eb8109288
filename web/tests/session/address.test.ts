import { describe, expect, it } from "vitest";
import { addressWith, placeOfAddress } from "../../shared/session/address";

describe("the address", () => {
  it("names the run and the document, and keeps what else it says", () => {
    expect(placeOfAddress(addressWith("", { run: "7" }))).toEqual({ run: "7", edit: undefined });
    expect(addressWith("?lang=en&run=7", { run: "8", edit: "pick" })).toBe("?lang=en&run=8&edit=pick");
    expect(addressWith("?run=8&edit=pick", { edit: undefined })).toBe("?run=8");
    expect(placeOfAddress("")).toEqual({ run: undefined, edit: undefined });
  });
});
