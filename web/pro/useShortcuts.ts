// Keyboard shortcuts of the page. The browser's default action of a handled key is prevented.
import { useEffect, useEffectEvent } from "react";
import { shortcutOf, type Shortcut } from "../shared/session/shortcuts";

/** Whether characters that are typed go into `target`. */
export function isTyping(target: EventTarget | null): boolean {
  return target instanceof HTMLElement && (target.isContentEditable || target.matches("input:not([type=checkbox]), textarea, select"));
}

/** `act` returns whether it handled the shortcut; `held`: the key is held, and this is not its first event. */
export function useShortcuts(act: (shortcut: Shortcut, held: boolean) => boolean): void {
  const latest = useEffectEvent(act);
  useEffect(() => {
    const press = (event: KeyboardEvent) => {
      const shortcut = shortcutOf(event, isTyping(event.target));
      if (shortcut !== undefined && latest(shortcut, event.repeat)) event.preventDefault();
    };
    addEventListener("keydown", press);
    return () => removeEventListener("keydown", press);
  }, []);
}
