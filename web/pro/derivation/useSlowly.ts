// What changes many times a second, at a pace that can be read and drawn.
import { useEffect, useRef, useState } from "react";

/** The value, late by at most `period` [ms] while it changes often, and at once when it has rested for so long. */
export function useSlowly<T>(value: T, period: number): T {
  const [shown, setShown] = useState(value);
  const last = useRef(-Infinity);
  useEffect(() => {
    if (Object.is(value, shown)) return;
    const timer = setTimeout(() => {
      last.current = performance.now();
      setShown(value);
    }, Math.max(0, last.current + period - performance.now()));
    return () => clearTimeout(timer);
  }, [value, shown, period]);
  return shown;
}
