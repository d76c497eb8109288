// The others at the document, as components show them.
import { useMemo } from "react";
import type { PersonAt } from "../../generated/messages";
import { distinctNames } from "../../shared/presence/names";
import { othersOf, type People } from "../../shared/presence/people";
import { people, usePeople } from "./presence";

export interface Other {
  readonly person: PersonAt;
  /** By which they can be told apart. */
  readonly name: string;
}

const kNone: readonly Other[] = [];
let last: { readonly of: People; readonly others: readonly Other[] } | undefined;

/** The same object as long as nothing of it changed. */
export function others(of: People = people.get()): readonly Other[] {
  if (last?.of === of) return last.others;
  const all = othersOf(of);
  const names = distinctNames(all);
  last = { of, others: all.length === 0 ? kNone : all.map((person) => ({ person, name: names.get(person.id) ?? person.name })) };
  return last.others;
}

export const useOthers = (): readonly Other[] => usePeople(others);

/** What `select` gives, the same object until its text is another one: most messages only move pointers. */
export function useOfOthers<T>(select: (others: readonly Other[]) => T): T {
  const text = usePeople((of) => JSON.stringify(select(others(of))));
  return useMemo(() => JSON.parse(text) as T, [text]);
}
