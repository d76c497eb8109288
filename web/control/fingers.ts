// One finger at a time: while a button is held, whatever else touches the page. Which of two fingers means something, and which one rests on the screen, nobody knows: nothing moves, and what moves stops.

/** Calls `act` when a pointer comes down that is not `held` (of the button; nothing: a key holds it), wherever that is in `page`; the result ends that. What it touches is not kept from it: it may be STOP. */
export function watchFingers(page: Pick<EventTarget, "addEventListener" | "removeEventListener">, held: number | undefined, act: () => void): () => void {
  const down = (event: Event) => {
    if (!("pointerId" in event) || event.pointerId !== held) act();
  };
  page.addEventListener("pointerdown", down, { capture: true });
  return () => page.removeEventListener("pointerdown", down, { capture: true });
}
