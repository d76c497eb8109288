import { describe, expect, it } from "vitest";
import type { PersonAt } from "../../generated/messages";
import { applyPeople, nobody, othersOf, peopleEvent, selfOf, type People, type PeopleEvent } from "../../shared/presence/people";

const person = (id: number, name = `P${id}`, colour = 0): PersonAt => ({ id, name, colour });
const after = (events: readonly PeopleEvent[], people: People = nobody): People => events.reduce(applyPeople, people);
const open: PeopleEvent = { type: "open", document: "task", connected: true };
const idsOf = (people: People) => othersOf(people).map(({ id }) => id);

describe("the people at a document", () => {
  it("are those of the snapshot, with what deltas change", () => {
    const people = after([open, { type: "snapshot", data: { people: [person(1), person(2)] } }, { type: "joined", id: 2 }]);
    expect(idsOf(people)).toEqual([1]);
    const next = after([{ type: "delta", data: { people: [person(1, "Ada"), person(7)], left: [] } }, { type: "delta", data: { people: [], left: [7, 99] } }], people);
    expect(othersOf(next)).toEqual([person(1, "Ada")]);
    expect(selfOf(next)).toEqual(person(2));
  });

  it("are not shown before it is known who of them is at this page", () => {
    const people = after([open, { type: "snapshot", data: { people: [person(1), person(2)] } }]);
    expect(idsOf(people)).toEqual([]);
    expect(idsOf(after([{ type: "joined", id: 1 }], people))).toEqual([2]);
  });

  it("are all others for somebody who has no room", () => {
    const refused: PeopleEvent = { type: "refused", errors: [{ path: "document", code: "too_large", message: "64" }] };
    const people = after([open, { type: "snapshot", data: { people: [person(1), person(2)] } }, refused]);
    expect(idsOf(people)).toEqual([1, 2]);
    const later = after([{ type: "joined", id: 3 }], people);
    expect(later.full).toBe(false);
  });

  it("do not have the person at this page twice after a reconnect", () => {
    const people = after([open, { type: "snapshot", data: { people: [person(1), person(2)] } }, { type: "joined", id: 2 }, { type: "connection", connected: false }]);
    expect(idsOf(people), "nothing is known of them").toEqual([]);
    const back = after([{ type: "connection", connected: true }, { type: "delta", data: { people: [person(3)], left: [] } }, { type: "joined", id: 3 }], people);
    expect(idsOf(back)).toEqual([1]);
    expect(selfOf(back)?.id).toBe(3);
  });

  it("are forgotten with the document", () => {
    const people = after([open, { type: "snapshot", data: { people: [person(1)] } }, { type: "joined", id: 2 }]);
    expect(after([{ type: "open", document: undefined, connected: false }], people)).toEqual(nobody);
  });
});

describe("peopleEvent", () => {
  it("reads what is about this document alone", () => {
    const people = { people: [person(1)] };
    expect(peopleEvent("task", { type: "people", channel: "presence/task", people })).toEqual({ type: "snapshot", data: people });
    expect(peopleEvent("task", { type: "people", channel: "presence/task2", people })).toBeUndefined();
    expect(peopleEvent("task", { type: "people_changed", channel: "presence/other", change: { people: [], left: [1] } })).toBeUndefined();
    expect(peopleEvent("task", { type: "joined", joined: { document: "other", id: 3 } })).toBeUndefined();
    expect(peopleEvent("task", { type: "refused", channel: "document/task", errors: [{ path: "", code: "not_found", message: "" }] })).toBeUndefined();
    expect(peopleEvent("task", { type: "derivation_position", id: "1", next: 1 })).toBeUndefined();
  });
});
