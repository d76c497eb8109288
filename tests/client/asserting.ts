// What the conversations assert often.
import { RaceError, type Client, type messages } from "../../api/typescript/src/index";

/** The error of something that is refused with this status and code. */
export async function refused(status: number, code: string, asked: Promise<unknown>): Promise<RaceError> {
  const error: unknown = await asked.then((answer) => new Error(`it is answered: ${JSON.stringify(answer)}`), (thrown: unknown) => thrown);
  if (!(error instanceof RaceError)) throw error;
  expect([error.status, error.code], error.message).toEqual([status, code]);
  return error;
}

export async function all<T>(items: AsyncIterable<T>): Promise<T[]> {
  const found: T[] = [];
  for await (const item of items) found.push(item);
  return found;
}

/** The next of something that goes on. */
export async function next<T>(items: AsyncIterator<T, unknown>): Promise<T> {
  const { done, value } = await items.next();
  if (done === true) throw new Error("it has ended");
  return value;
}

/** A state whose lists have no order, for comparison. */
export const sets = ({ state }: messages.CoreState) => ({
  ...state,
  active: new Set(state.active),
  ports: new Set(state.ports),
  activated: Object.fromEntries(Object.entries(state.activated).map(([path, ports]) => [path, new Set(ports)])),
});

/** The core once `holds` is true of it. */
export async function until(race: Client, id: string, holds: (core: messages.Core) => boolean): Promise<messages.Core> {
  for (const end = Date.now() + 20_000; ; await new Promise((resolve) => setTimeout(resolve, 20))) {
    const core = await race.cores.get(id);
    if (holds(core)) return core;
    if (Date.now() > end) throw new Error(`core ${id} is still ${JSON.stringify(core)}`);
  }
}

/** The core once a request tells its end, too: the stream may have told it a moment before. */
export const untilOver = (race: Client, id: string): Promise<messages.Core> => until(race, id, ({ status }) => status !== "ready" && status !== "running");
