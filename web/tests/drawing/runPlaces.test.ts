import { describe, expect, it } from "vitest";
import type { RcmDocument, State } from "../../shared/model/model";
import type { Places } from "../../shared/drawing/places";
import { runPlaces } from "../../shared/drawing/runPlaces";

const state = (name: string, id: string, more: Partial<State> = {}): State => ({ kind: "state", name, id, parameters: [], results: [], variables: [], actions: [], children: [], ports: [], ...more });

const document: RcmDocument = {
  name: "task", services: {},
  library: [state("Pick", "lib", { children: [state("Grasp", "grasp"), { kind: "barrier", id: "fork", name: "Fork", to: [] }] })],
  root: state("Root", "root", { children: [state("Left", "left", { link: "Pick" }), state("Right", "right", { link: "Pick" }), state("Last", "last")] }),
};
const taken = (id: string) => [state("Grasp", `${id}-grasp`), { kind: "barrier", id: `${id}-fork`, name: "Fork", to: [] } as const];
/** As the server translates it. */
const native = state("Root", "root", { children: [state("Left", "left", { children: taken("left") }), state("Right", "right", { children: taken("right") }), state("Last", "last")] });

describe("the places of a run", () => {
  it("are those of its document, and in links those of the library", () => {
    const places: Places = new Map([
      ["last", { x: 1, y: 2, side: "EAST", parent: "root" }],
      ["grasp", { x: 3, y: 4, side: "SOUTH", parent: "lib" }],
      ["fork", { x: 5, y: 6, side: "EAST" }],
    ]);
    expect([...runPlaces(document, native, places)].sort()).toEqual([
      ["last", { x: 1, y: 2, side: "EAST", parent: "root" }],
      ["left-fork", { x: 5, y: 6, side: "EAST", parent: "left" }],
      ["left-grasp", { x: 3, y: 4, side: "SOUTH", parent: "left" }],
      ["right-fork", { x: 5, y: 6, side: "EAST", parent: "right" }],
      ["right-grasp", { x: 3, y: 4, side: "SOUTH", parent: "right" }],
    ]);
  });
  it("are not those from another state", () => {
    expect(runPlaces(document, native, new Map([["last", { x: 1, y: 2, side: "EAST", parent: "lib" }]])).size).toBe(0);
  });
});
