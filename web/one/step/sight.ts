// What the camera sees now: its service is asked when a field is opened and when a person says so, once for all who ask meanwhile.
import { createStore } from "../../page/store";
import type { JsonValue } from "../../shared/json";
import { messageOf } from "../../shared/messageOf";
import { labelsKnown, labelsSeen } from "../../shared/skills/labels";
import { texts } from "../texts";

export interface SightState {
  readonly isLooking: boolean;
  /** The labels of what it sees; nothing: it has not said so. */
  readonly seen: readonly string[] | undefined;
  /** The labels of all that its service can find. */
  readonly known: readonly string[];
  /** Why it does not say what it sees. */
  readonly problem: string | undefined;
}

/** So long the camera may look [ms]; its service has given up by then. */
const kPatience = 15_000;

/** Rejects if it takes too long. */
function inTime<T>(answer: Promise<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    const timer = setTimeout(() => reject(new Error(texts.sight.noAnswer)), kPatience);
    answer.then(resolve, reject).finally(() => clearTimeout(timer));
  });
}

/** `call`: an operation of a service, which reads. */
export function createSight(call: (service: string, operation: string) => Promise<JsonValue>) {
  const store = createStore<SightState, Partial<SightState>>({ isLooking: false, seen: undefined, known: [], problem: undefined }, (now, change) => ({ ...now, ...change }));

  /** What was known stays, if it is not told again: to look fails for the same reason, and says so. */
  const askLabels = (service: string): Promise<void> =>
    call(service, "labels").then(
      (response) => store.dispatch({ known: labelsKnown(response) }),
      () => undefined,
    );
  const askSight = (service: string): Promise<void> =>
    inTime(call(service, "look")).then(
      (response) => store.dispatch({ seen: labelsSeen(response), problem: undefined, isLooking: false }),
      (error: unknown) => store.dispatch({ seen: undefined, problem: messageOf(error), isLooking: false }),
    );

  return {
    store,
    /** Asks the service that finds parts, unless that is under way. */
    look(service: string): void {
      if (store.get().isLooking) return;
      store.dispatch({ isLooking: true });
      void askLabels(service);
      void askSight(service);
    },
  };
}
