// What a state does once its link is followed: its code, ports and children, as far as calls are concerned.
import type { Node, Port, RcmDocument, State } from "../model/model";

/** A port and the condition with which it fires; `to` of the state that has it. */
export interface Exit {
  readonly name: string;
  readonly when: string;
  readonly timed: boolean;
  readonly to: string | undefined;
}

export interface Behavior {
  /** The states that it is written in: itself, and the library states that it takes over. */
  readonly sources: readonly State[];
  readonly entry: string;
  readonly exit: string;
  readonly actions: readonly string[];
  readonly children: readonly Node[];
  readonly first: string | undefined;
  readonly exits: readonly Exit[];
  readonly oracle: string | undefined;
  /** It links what is not there, or itself: it may do anything. */
  readonly unknown: boolean;
}

const exitOf = (port: Port): Exit => ({ name: port.name, when: port.when ?? "", timed: port.after !== undefined, to: port.to });

const own = (state: State, unknown: boolean): Behavior => ({
  sources: [state], entry: state.entry ?? "", exit: state.exit ?? "", actions: state.actions.map((action) => action.do), children: state.children, first: state.first,
  exits: state.ports.map(exitOf), oracle: state.oracle, unknown,
});

/** `within`: the library states that are being taken over, each by the one before. */
export function behaviorOf({ library }: Pick<RcmDocument, "library">, state: State, within: readonly string[] = []): Behavior {
  if (state.link === undefined) return own(state, false);
  const linked = library.find(({ name }) => name === state.link);
  if (linked === undefined || within.includes(state.link)) return own(state, true);
  const inner = behaviorOf({ library }, linked, [...within, state.link]);
  const target = (name: string) => state.ports.find((port) => port.name === name)?.to;
  return { ...inner, sources: [state, ...inner.sources], exits: inner.exits.map((exit) => ({ ...exit, to: target(exit.name) })) };
}
