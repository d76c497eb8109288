import { describe, expect, it } from "vitest";
import { readStreamMessage } from "../../shared/messages/stream";
import { depthColour, kFarthest, kNearest, pixels } from "../../shared/service/pixels";
import { readJson } from "../files";

/** 2x1 pixels: 1.25 m away and not measured; (200, 10, 20) and (0, 128, 255). */
const { update } = readStreamMessage(readJson(new URL("../../../api/examples/stream_message.flow_delta.json", import.meta.url)));
const picture = update.type === "packet" ? update.packet.picture : undefined;
if (picture === undefined) throw new Error("the example has no picture");

describe("pixels", () => {
  it("are the colours as they were sent, opaque", () => expect([...pixels(picture, "colour")]).toEqual([200, 10, 20, 255, 0, 128, 255, 255]));
  it("are the false colours of the depths, low byte first", () =>
    expect([...pixels(picture, "depth")]).toEqual([...depthColour(1250), 255, ...depthColour(0), 255]));
  it("are black where a picture lacks data", () =>
    expect([...pixels({ ...picture, height: 2 }, "colour")].slice(8)).toEqual([0, 0, 0, 255, 0, 0, 0, 255]));
});

describe("depthColour", () => {
  const lightness = (depth: number) => depthColour(depth).reduce((sum, value) => sum + value, 0);
  it("gets darker with every decimetre of the range", () => {
    for (let depth = kNearest; depth < kFarthest; depth += 100) expect(lightness(depth + 100)).toBeLessThan(lightness(depth));
  });
  it("is that of the end beyond the range", () => {
    expect(depthColour(1)).toEqual(depthColour(kNearest));
    expect(depthColour(65535)).toEqual(depthColour(kFarthest));
  });
  it("distinguishes unmeasured from measured pixels", () => {
    for (let depth = 1; depth <= kFarthest; depth++) expect(depthColour(depth)).not.toEqual(depthColour(0));
  });
});
