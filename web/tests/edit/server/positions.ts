// The lists that edits have touched, with the places that elements have left (core/edit/positions.h).
import type { ListName } from "../../../shared/edit/element";
import { listOf, type Tree } from "../../../shared/edit/tree";

/** The number of a departure, from 1; 0: none. */
export type Departure = number;

export interface Place {
  readonly parent: string;
  readonly list: ListName;
  readonly after?: string;
}

/** A place for an element to enter, in terms of the tree. */
export interface Spot {
  readonly place: Place;
  readonly slot: number;
  /** To a slot that is there already. */
  readonly isReturn: boolean;
}

interface Slot {
  readonly id: string;
  /** 0: the element is there. */
  readonly left: Departure;
}

const keyOf = (parent: string, list: ListName): string => `${parent}/${list}`;

type Lists = ReadonlyMap<string, readonly Slot[]>;

/** A value: each change gives another one. */
export class Positions {
  private constructor(
    private readonly lists: Lists,
    /** Those of elements that a departure has removed. */
    private readonly stored: ReadonlyMap<Departure, Lists>,
    readonly last: Departure,
  ) {}

  static readonly none = new Positions(new Map(), new Map(), 0);

  private with(parent: string, list: ListName, slots: readonly Slot[], last = this.last): Positions {
    return new Positions(new Map(this.lists).set(keyOf(parent, list), slots), this.stored, last);
  }

  private slots(parent: string, list: ListName): readonly Slot[] {
    return this.lists.get(keyOf(parent, list)) ?? [];
  }

  /** Must come before the other calls for a list, while the tree is as these calls left it. */
  sync(tree: Tree, parent: string, list: ListName): Positions {
    const present = listOf(tree, parent, list);
    const known = this.slots(parent, list).filter((slot) => slot.left === 0);
    if (this.lists.has(keyOf(parent, list)) && known.length === present.length && known.every((slot, i) => slot.id === present[i])) return this;
    return this.with(parent, list, present.map((id) => ({ id, left: 0 })));
  }

  leave(parent: string, list: ListName, id: string): Positions {
    const last = this.last + 1;
    return this.with(parent, list, this.slots(parent, list).map((slot) => (slot.left === 0 && slot.id === id ? { id, left: last } : slot)), last);
  }

  /** Behind `place.after`, or behind the place that it has left with a departure after `since`, up to `until`. */
  spot(place: Place, since: Departure, until: Departure): Spot | undefined {
    const { parent, list, after } = place;
    if (after === undefined) return { place, slot: 0, isReturn: false };
    const slots = this.slots(parent, list);
    const present = slots.findIndex((slot) => slot.left === 0 && slot.id === after);
    if (present !== -1) return { place, slot: present + 1, isReturn: false };
    const left = slots.filter((slot) => slot.id === after && slot.left > since && slot.left <= until).map((slot) => slot.left);
    if (left.length === 0) return undefined;
    const best = Math.max(...left);
    return this.spotAt(parent, list, slots.findIndex((slot) => slot.left === best) + 1, false);
  }

  /** The place that was left by `departure`. */
  spotOf(parent: string, list: ListName, departure: Departure): Spot | undefined {
    const slot = departure === 0 ? -1 : this.slots(parent, list).findIndex(({ left }) => left === departure);
    return slot === -1 ? undefined : this.spotAt(parent, list, slot, true);
  }

  private spotAt(parent: string, list: ListName, slot: number, isReturn: boolean): Spot {
    const after = this.slots(parent, list).slice(0, slot).filter(({ left }) => left === 0).at(-1)?.id;
    return { place: { parent, list, ...(after !== undefined && { after }) }, slot, isReturn };
  }

  enter({ place: { parent, list }, slot, isReturn }: Spot, id: string): Positions {
    const slots = this.slots(parent, list);
    return this.with(parent, list, [...slots.slice(0, slot), { id, left: 0 }, ...slots.slice(isReturn ? slot + 1 : slot)]);
  }

  /** The lists of `elements`, which were removed by `departure`, go with them. */
  store(elements: readonly string[], departure: Departure): Positions {
    const ids = new Set(elements);
    const isOfThem = ([key]: readonly [string, unknown]) => ids.has(key.slice(0, key.lastIndexOf("/")));
    const lists = [...this.lists];
    const stored = new Map(this.stored).set(departure, new Map(lists.filter(isOfThem)));
    return new Positions(new Map(lists.filter((list) => !isOfThem(list))), stored, this.last);
  }

  /** They are back, as what was removed by `departure` is. */
  restore(departure: Departure): Positions {
    return new Positions(new Map([...this.lists, ...(this.stored.get(departure) ?? [])]), this.stored, this.last);
  }
}
