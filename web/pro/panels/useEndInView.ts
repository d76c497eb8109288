// A list that grows at its end: the end stays in view while it is, and who has scrolled back reads on there.
import { useEffect, useRef, type RefObject, type UIEvent } from "react";

/** So near to the end counts as there [px]. */
const kNear = 40;

interface EndInView<Element extends HTMLElement> {
  readonly ref: RefObject<Element | null>;
  readonly onScroll: (event: UIEvent) => void;
}

/** What the element that scrolls takes; `items`: another object whenever there are others. */
export function useEndInView<Element extends HTMLElement>(items: readonly unknown[]): EndInView<Element> {
  const ref = useRef<Element>(null);
  const follows = useRef(true);
  useEffect(() => {
    if (follows.current && ref.current !== null) ref.current.scrollTop = ref.current.scrollHeight;
  }, [items]);
  const onScroll = ({ currentTarget: { scrollHeight, scrollTop, clientHeight } }: UIEvent) => void (follows.current = scrollHeight - scrollTop - clientHeight < kNear);
  return { ref, onScroll };
}
