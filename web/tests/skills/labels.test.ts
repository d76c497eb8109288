// The labels that a field offers: what is seen, what can be found, and what documents name, each once.
import { describe, expect, it } from "vitest";
import { labelsKnown, labelsSeen, offeredLabels, recognitionOf } from "../../shared/skills/labels";

const part = (label: string) => ({ label, pose: { position: [0, 0, 1], orientation: [0, 0, 0, 1] }, confidence: 0.9 });

describe("the labels that are offered", () => {
  it("are those that are seen, then those of the service, then those of documents", () => {
    expect(offeredLabels(["Tape", "Bar"], ["Cube", "Tape", "Box"], ["Gear", "Box", "Axle"])).toEqual({ seen: ["Bar", "Tape"], others: ["Box", "Cube", "Axle", "Gear"] });
  });

  it("are each there once, and none is empty", () => {
    expect(offeredLabels(["Bar", "Bar"], ["Bar", "Bar", ""], ["", "Bar"])).toEqual({ seen: ["Bar"], others: [] });
  });

  it("are those of documents alone, if the service is away", () => {
    expect(offeredLabels([], [], ["Gear", "Axle"])).toEqual({ seen: [], others: ["Axle", "Gear"] });
  });
});

describe("a response of the service", () => {
  it("has the labels of what is seen, and of all that it can find", () => {
    expect(labelsSeen({ time: 1.5, objects: [part("Tape"), part("Bar")] })).toEqual(["Tape", "Bar"]);
    expect(labelsKnown(["Cube", "Tool"])).toEqual(["Cube", "Tool"]);
  });

  it("that is no such thing has none", () => {
    for (const other of [null, 3, "Tape", [], {}, { objects: null }, { objects: [null, 1, { label: 7 }, {}] }]) expect(labelsSeen(other)).toEqual([]);
    for (const other of [null, "Cube", { labels: ["Cube"] }, [1, null]]) expect(labelsKnown(other)).toEqual([]);
  });
});

describe("the service that finds parts", () => {
  const services = (available: boolean) => [
    { key: "camera", type: "KinectDriver", available: true },
    { key: "eyes", type: "ObjectRecognition", available },
  ];
  it("is known by its type, whatever its key", () => expect(recognitionOf(services(true))).toBe("eyes"));
  it("is nothing while it is not available, or where there is none", () => {
    expect(recognitionOf(services(false))).toBeUndefined();
    expect(recognitionOf([])).toBeUndefined();
  });
});
