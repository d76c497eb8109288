// Acts on the keys of the page. A key that a handler takes is not the browser's any more.
import { useEffect, useEffectEvent } from "react";
import { shortcutOf, type Shortcut } from "../shared/session/shortcuts";

function isTyping(target: EventTarget | null): boolean {
  return target instanceof HTMLElement && (target.isContentEditable || target.matches("input:not([type=checkbox]), textarea, select"));
}

/** `act` says whether it took the shortcut. */
export function useShortcuts(act: (shortcut: Shortcut) => boolean): void {
  const latest = useEffectEvent(act);
  useEffect(() => {
    const press = (event: KeyboardEvent) => {
      const shortcut = shortcutOf(event, isTyping(event.target));
      if (shortcut !== undefined && latest(shortcut)) event.preventDefault();
    };
    addEventListener("keydown", press);
    return () => removeEventListener("keydown", press);
  }, []);
}
