// A menu at a place of the screen. What cannot be chosen stays readable, with its reason.
import { useEffect, useLayoutEffect, useRef, useState, type KeyboardEvent } from "react";
import { endPrompt, type MenuEntry, type ScreenPoint } from "../prompt";

interface Props {
  readonly label: string;
  readonly at: ScreenPoint;
  readonly entries: readonly MenuEntry[];
}

/** Distance that it keeps from the edge of the window [px]. */
const kMargin = 8;

/** Where the focus goes by a key among `count` entries. */
function nextIndex(key: string, at: number, count: number): number | undefined {
  switch (key) {
    case "ArrowDown":
      return (at + 1) % count;
    case "ArrowUp":
      return (at + count - 1) % count;
    case "Home":
      return 0;
    case "End":
      return count - 1;
    default:
      return undefined;
  }
}

export function Menu({ label, at, entries }: Props) {
  const list = useRef<HTMLUListElement>(null);
  const [place, setPlace] = useState(at);
  const items = () => [...(list.current?.querySelectorAll<HTMLElement>('[role="menuitem"]') ?? [])];
  useLayoutEffect(() => {
    const { width, height } = list.current?.getBoundingClientRect() ?? { width: 0, height: 0 };
    setPlace({ x: Math.max(kMargin, Math.min(at.x, innerWidth - width - kMargin)), y: Math.max(kMargin, Math.min(at.y, innerHeight - height - kMargin)) });
  }, [at]);
  useEffect(() => items()[0]?.focus(), []);
  useEffect(() => {
    const outside = (event: PointerEvent) => event.target instanceof Node && list.current?.contains(event.target) === false && endPrompt();
    addEventListener("pointerdown", outside, true);
    addEventListener("blur", endPrompt);
    return () => {
      removeEventListener("pointerdown", outside, true);
      removeEventListener("blur", endPrompt);
    };
  }, []);
  const press = (event: KeyboardEvent) => {
    const all = items();
    const current = all.findIndex((item) => item === document.activeElement);
    const next = nextIndex(event.key, current, all.length) ?? (event.key.length === 1 ? letterIndex(all, event.key, current) : undefined);
    if (event.key === "Escape" || event.key === "Tab") endPrompt();
    else if (next === undefined) return;
    else all[next]?.focus();
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <ul ref={list} className="menu" role="menu" aria-label={label} style={{ left: place.x, top: place.y }} onKeyDown={press} onContextMenu={(event) => event.preventDefault()}>
      {entries.map((entry) => (
        <li key={entry.name} role="none">
          <Item entry={entry} />
        </li>
      ))}
    </ul>
  );
}

/** The next entry that begins with a letter. */
function letterIndex(items: readonly HTMLElement[], letter: string, current: number): number | undefined {
  const order = items.map((_, i) => (current + 1 + i) % items.length);
  return order.find((i) => items[i]?.textContent.toLowerCase().startsWith(letter.toLowerCase()) === true);
}

function Item({ entry: { name, keys, reason, run } }: { readonly entry: MenuEntry }) {
  const choose = () => {
    if (reason !== undefined) return;
    endPrompt();
    run();
  };
  return (
    <button type="button" role="menuitem" tabIndex={-1} aria-disabled={reason !== undefined} onClick={choose} onPointerEnter={(event) => event.currentTarget.focus({ preventScroll: true })}>
      <span>{name}</span>
      {keys !== undefined && keys !== "" && <kbd>{keys}</kbd>}
      {reason !== undefined && <small>{reason}</small>}
    </button>
  );
}
