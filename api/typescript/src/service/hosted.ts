// One service while it is offered: its calls, its state, and what it says.
import type { JsonObject } from "../json.js";
import { bindArguments } from "./arguments.js";
import { Declaration } from "./declaration.js";
import { isDeferring, Machine } from "./machine.js";
import type { CallMessage, ServiceMessage, ViolationMessage } from "./messages.js";
import type { OperationModel, Transition } from "./rsm.js";
import { atMost, Call, type Outcome } from "./runningCall.js";
import { kHost, ServiceFailure, Stopped, type Host, type Service } from "./service.js";
import { checkedError, checkedValue, messageOf, shortText } from "./values.js";

/** Calls at work at once. */
export const kMaxCalls = 100;
/** [s] for what is called when the server is lost. */
const kHaltTime = 2;

/** Sends a message. */
export type Say = (message: JsonObject) => void;
/** Shows a line to the author of the service. */
export type Log = (line: string) => void;

const traceOf = (thrown: unknown): string => (thrown instanceof Error ? (thrown.stack ?? thrown.message) : String(thrown));

/** Joins a Service to whoever brings messages of the server. The constructor throws a DeclarationError: its class is none. */
export class Hosted implements Host {
  readonly declaration: Declaration;
  private readonly operations: ReadonlyMap<string, OperationModel>;
  private machine: Machine;
  private say: Say | undefined;
  private readonly calls = new Map<number, Call>();
  /** Also of calls that are over. */
  private readonly working = new Map<Call, Promise<void>>();
  /** Ends when all that halts has. */
  private halting: Promise<void> | undefined;

  constructor(
    private readonly service: Service,
    private readonly show: Log,
  ) {
    this.declaration = new Declaration(service);
    this.operations = new Map(this.declaration.model.operations.map((each) => [each.name, each]));
    this.machine = new Machine(this.declaration.model);
    service[kHost] = this;
  }

  get state(): string {
    return this.say === undefined ? "" : this.machine.state;
  }

  /** As a hello names it. */
  component(): JsonObject {
    const { key, type, rsm } = this.declaration;
    return { key, type, rsm };
  }

  /** The server is there, and knows it in its first state. */
  connected(say: Say): void {
    this.machine = new Machine(this.declaration.model);
    this.say = say;
    this.service.speedLimit = undefined; // the server says it if there is one
  }

  /** The server is there no more: nobody waits for anything. */
  async lost(): Promise<void> {
    if (this.say === undefined) return;
    this.say = undefined;
    for (const call of [...this.calls.values()]) this.end(call);
    await this.halt();
  }

  /** Nothing was heard for too long: what is under way ends, and is answered. What is safe and not busy goes on: it ends a motion. */
  async silent(): Promise<void> {
    const goesOn = ({ transition, operation }: Call): boolean => !isDeferring(transition) && this.operations.get(operation)?.isSafe === true;
    for (const call of [...this.calls.values()].filter((each) => !goesOn(each))) {
      this.answer(call, { error: { code: "stopped", message: "the server is silent" } });
      call.stop();
    }
    await this.halt();
  }

  /** A message of the server for this service. */
  received(message: ServiceMessage): void {
    if (message.type === "call") this.called(message);
    else if (message.type === "violation") this.violated(message);
    else this.service.speedLimit = message.speed;
  }

  /** Throws a TypeError or a RangeError: the data is no JSON. */
  emit(event: string, data: unknown): void {
    this.announce({ type: "event", name: event, data: checkedValue(data) });
  }

  /** Throws a RangeError: there is no such transition. */
  take(transition: string): void {
    this.takeBy(this.machine.transition(transition));
  }

  log(text: string): void {
    this.announce({ type: "log", text: shortText(text, 300) });
  }

  /** Says something, if the server is there. */
  private announce(message: JsonObject): void {
    this.say?.({ key: this.declaration.key, ...message });
  }

  private violated(violation: ViolationMessage): void {
    const ofCall = violation.call === 0 ? "" : ` (call ${violation.call})`;
    this.show(`${this.declaration.whereViolated(violation)}: violation: ${violation.rule}: ${violation.message}${ofCall}`);
  }

  // ---- Calls.

  private called({ call: number, operation: name, args, kwargs }: CallMessage): void {
    const operation = this.operations.get(name);
    const { isInterface } = this.declaration.model;
    const transition = isInterface ? undefined : this.machine.accepting(name);
    if (operation === undefined || (transition === undefined && !isInterface)) {
      this.announce({ type: "reject", call: number });
      return;
    }
    const call = new Call(number, name, transition);
    this.calls.set(number, call);
    if (transition !== undefined) this.takeBy(transition, number);
    const bound = bindArguments(operation.parameters, args, kwargs);
    if (bound.error !== undefined) this.answer(call, bound);
    else if (this.working.size >= kMaxCalls) this.answer(call, { error: { code: "too_many", message: `${kMaxCalls} calls are at work` } });
    else this.working.set(call, this.run(call, bound.values).finally(() => this.working.delete(call)));
  }

  /** Does the work of a call. One that was stopped and has not ended yet is waited for: it may still move something. */
  private async run(call: Call, args: JsonObject): Promise<void> {
    await this.halting;
    for (let ending = this.ending(call); ending.length > 0 && !call.isOver; ending = this.ending(call)) await Promise.all(ending);
    if (!call.isOver) this.answer(call, await this.outcome(call, args));
  }

  /** What a call that makes the service busy waits for. */
  private ending(call: Call): readonly Promise<void>[] {
    if (!isDeferring(call.transition)) return [];
    return [...this.working].filter(([each]) => each !== call && each.isOver).map(([, work]) => work);
  }

  private async outcome(call: Call, args: JsonObject): Promise<Outcome> {
    try {
      return { value: checkedValue(await this.declaration.operations.get(call.operation)?.work(args, call.running)) };
    } catch (failure) {
      if (failure instanceof ServiceFailure) return { error: checkedError(failure.error) };
      // What was aborted, such as a `fetch`, says so in its own way.
      if (failure instanceof Stopped || (call.isOver && failure instanceof Error && failure.name === "AbortError")) return { error: { code: "stopped" } };
      this.show(`${this.declaration.where(call.operation)}: error: \`${call.operation}\` has failed\n${traceOf(failure)}`);
      const name = failure instanceof Error ? `${failure.name}: ` : "";
      return { error: { code: "failed", message: shortText(name + messageOf(failure), 500) } };
    }
  }

  /** Answers a call that still waits, by the transition that is due. */
  private answer(call: Call, outcome: Outcome): void {
    if (call.isOver) return;
    const { number, transition } = call;
    if (isDeferring(transition)) {
      const ending = this.machine.ending(transition, outcome.error?.code);
      if (ending !== undefined) this.takeBy(ending, transition.isConcurrent === true ? number : 0, call);
      this.machine.drop(number);
    }
    this.respond(call, outcome);
  }

  /** Takes a transition, by a call (0: by none); what it answers, but for `own` and that call, whose work begins, ends. */
  private takeBy(transition: Transition, number = 0, own?: Call): void {
    this.announce({ type: "transition", id: transition.id, ...(number === 0 ? {} : { call: number }) });
    const { resolved, superseded } = this.machine.take(transition, number);
    for (const { call, code } of resolved) {
      const other = this.calls.get(call);
      if (other === undefined || other === own || call === number) continue;
      this.respond(other, code === undefined ? { value: null } : { error: { code } });
      other.stop();
    }
    const replaced = this.calls.get(superseded);
    if (replaced !== undefined) this.end(replaced);
  }

  private respond(call: Call, outcome: Outcome): void {
    const { number } = call;
    if (outcome.error === undefined) this.announce({ type: "result", call: number, value: outcome.value });
    else this.announce({ type: "error", call: number, error: outcome.error });
    this.calls.delete(number);
    call.isOver = true;
  }

  /** Nobody waits for its answer. */
  private end(call: Call): void {
    this.calls.delete(call.number);
    call.stop();
  }

  /** One after the other, as two that overlap would not know of each other. */
  private async halt(): Promise<void> {
    const before = this.halting;
    this.halting = (async () => {
      await before;
      await Promise.all(this.halts().map((act) => this.tryToHalt(act)));
    })();
    await this.halting;
  }

  private async tryToHalt(act: (running: Call["running"]) => unknown): Promise<void> {
    try {
      await atMost(kHaltTime, act);
    } catch (error) {
      this.show(`${this.declaration.where()}: error: it cannot halt\n${traceOf(error)}`);
    }
  }

  private halts(): readonly ((running: Call["running"]) => unknown)[] {
    const { service } = this;
    if (service.halt !== undefined) return [() => service.halt?.()];
    const safe = this.declaration.model.operations.filter(({ isSafe }) => isSafe);
    return safe.map(({ name, parameters }) => (running) => this.declaration.operations.get(name)?.work(bindArguments(parameters, [], {}).values ?? {}, running));
  }
}
