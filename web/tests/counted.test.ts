import { describe, expect, it } from "vitest";
import { counted } from "../shared/counted";
import { errorsText } from "../shared/run/errorsText";
import { pastText, placeText } from "../shared/past/texts";
import { storedText } from "../shared/runs/texts";
import { openComments } from "../shared/edit/comments/comments";
import { changesText } from "../shared/live/texts";
import type { Core, Past } from "../generated/messages";

describe("a count in words", () => {
  it("has one, and several, also none", () => expect([0, 1, 2].map((count) => counted(count, "step"))).toEqual(["0 steps", "1 step", "2 steps"]));
  it("has several as it is said", () => expect([1, 2].map((count) => counted(count, "port has", "ports have"))).toEqual(["1 port has", "2 ports have"]));
  it("is right wherever there is one", () => {
    const [core, past] = [{ id: "1", document: "pick", step: 1, status: "ended" } as Core, { step: 1, micro: 1, complete: true } as Past];
    const texts = [errorsText(1), changesText(1), openComments(1), storedText(core).holds, pastText(past, core, true).holds, placeText(past)];
    expect(texts).toEqual(["1 error", "1 change", "1 open comment", "Ended, after 1 macro step.", "The run has 1 step and is over.", "At the end of macro step 1, after 1 micro step."]);
  });
});
