// The present state of one service, by its RSM: which calls it takes, and which transitions answer them. Without sockets and timers.
import type { Rsm, Transition } from "./rsm.js";

/** A call whose answer was deferred, and is due. */
export interface Resolved {
  readonly call: number;
  /** It is the error of this code; nothing: the result. */
  readonly code: string | undefined;
}

export interface Taken {
  /** The calls that the transition answers. */
  readonly resolved: readonly Resolved[];
  /** The call that has no answer any more, as this call has its place; 0: none. */
  readonly superseded: number;
}

/** Whether calls that take it are answered by other transitions, later. */
export const isDeferring = (transition: Transition | undefined): transition is Transition => (transition?.defer ?? []).length > 0;

/** Begins in the first state. Its rules are those of core/SEMANTICS.md, section 5. */
export class Machine {
  state: string;
  private readonly transitions: ReadonlyMap<string, Transition>;
  /** Calls that wait, by the transition that took them. */
  private readonly deferred = new Map<string, readonly number[]>();

  constructor({ init, transitions }: Pick<Rsm, "init" | "transitions">) {
    this.state = init;
    this.transitions = new Map(transitions.map((each) => [each.id, each]));
  }

  /** Throws a RangeError: there is none of this id. */
  transition(id: string): Transition {
    const found = this.transitions.get(id);
    if (found === undefined) throw new RangeError(`the RSM has no transition \`${id}\``);
    return found;
  }

  /** The transition by which the present state takes a call; nothing: it rejects it. */
  accepting(operation: string): Transition | undefined {
    return [...this.transitions.values()].find((each) => each.operation === operation && this.leavesHere(each));
  }

  /** Takes it, by a call (0: by none). */
  take(transition: Transition, call = 0): Taken {
    this.state = transition.dst;
    const superseded = transition.operation !== undefined && isDeferring(transition) ? this.wait(transition, call) : 0;
    const resolved = this.answeredBy(transition, transition.operation === undefined ? call : 0).map((each) => ({ call: each, code: transition.error }));
    return { resolved, superseded };
  }

  /** The transition that answers a call that `transition` took: with an error of this code, or with a result. */
  ending(transition: Transition, code: string | undefined): Transition | undefined {
    const all = (transition.defer ?? []).map((id) => this.transition(id)).filter(({ operation }) => operation === undefined);
    const leaving = all.filter((each) => this.leavesHere(each));
    const here = leaving.length > 0 ? leaving : all;
    return (code === undefined ? undefined : here.find(({ error }) => error === code)) ?? here.find(({ error }) => error === undefined);
  }

  /** The call has been answered otherwise. */
  drop(call: number): void {
    for (const [id, waiting] of this.deferred) this.deferred.set(id, waiting.filter((each) => each !== call));
  }

  private leavesHere({ src }: Transition): boolean {
    return src === undefined || src === this.state;
  }

  /** The call waits for its answer; the one whose place it takes, or 0. */
  private wait({ id, isConcurrent }: Transition, call: number): number {
    const waiting = this.deferred.get(id) ?? [];
    const superseded = isConcurrent === true ? undefined : waiting.at(-1);
    this.deferred.set(id, [...(superseded === undefined ? waiting : waiting.slice(0, -1)), call]);
    return superseded ?? 0;
  }

  /** One without `src` answers all; else those that are deferred to it: of concurrent ones the one that it names, or the earliest. */
  private answeredBy(transition: Transition, call: number): readonly number[] {
    const endsAll = transition.src === undefined;
    const isAnswered = (id: string) => endsAll || this.transition(id).defer?.includes(transition.id) === true;
    const deferring = [...this.deferred].filter(([id, waiting]) => waiting.length > 0 && isAnswered(id));
    const isOne = (id: string) => !endsAll && this.transition(id).isConcurrent === true;
    const earliest = Math.min(...deferring.filter(([id]) => isOne(id)).map(([, [first = 0]]) => first));
    const one = call === 0 ? earliest : call;
    const answered: number[] = [];
    for (const [id, waiting] of deferring) {
      const chosen = isOne(id) ? waiting.filter((each) => each === one) : waiting;
      answered.push(...chosen);
      this.deferred.set(id, waiting.filter((each) => !chosen.includes(each)));
    }
    return answered;
  }
}
