// Several sources of messages as one, in order of time.
import type { McapMessage } from "./message";

type Source = Iterable<McapMessage> | AsyncIterable<McapMessage>;

const iteratorOf = (source: Source): Iterator<McapMessage> | AsyncIterator<McapMessage> => (Symbol.asyncIterator in source ? source[Symbol.asyncIterator]() : source[Symbol.iterator]());

/** Each source is in order of time, and is asked for one message ahead. Of messages of the same time, those of earlier sources are first. */
export async function* inOrder(sources: readonly Source[]): AsyncGenerator<McapMessage, void, void> {
  const iterators = sources.map(iteratorOf);
  const heads: IteratorResult<McapMessage, unknown>[] = [];
  for (const iterator of iterators) heads.push(await iterator.next());
  for (;;) {
    let first: { readonly at: number; readonly message: McapMessage } | undefined;
    for (const [at, head] of heads.entries()) if (head.done !== true && (first === undefined || head.value.time < first.message.time)) first = { at, message: head.value };
    if (first === undefined) return;
    yield first.message;
    const next = await iterators[first.at]?.next();
    if (next !== undefined) heads[first.at] = next;
  }
}
