// What comes many times a second is handled once a frame, so that the page is drawn once for all of it.

/** Of a page that is not shown, the browser draws no frames: then it is handled after this time [ms]. */
const kLatest = 100;

/** Returns a function that adds an item; `take` gets them in order, at the next frame. */
export function frameQueue<T>(take: (item: T) => void): { readonly add: (item: T) => void; readonly isEmpty: () => boolean } {
  let waiting: T[] = [];
  let frame = 0;
  let late: ReturnType<typeof setTimeout> | undefined;
  const flush = () => {
    cancelAnimationFrame(frame);
    clearTimeout(late);
    const items = waiting;
    waiting = [];
    items.forEach(take);
  };
  const add = (item: T) => {
    waiting.push(item);
    if (waiting.length > 1) return;
    frame = requestAnimationFrame(flush);
    late = setTimeout(flush, kLatest);
  };
  return { add, isEmpty: () => waiting.length === 0 };
}
