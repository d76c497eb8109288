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

/** Letters typed within this time are one word [ms]. */
const kWord = 700;

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
  const typedRef = useRef({ text: "", at: -Infinity });
  /** Letters that follow each other at once are the beginning of a name. */
  const typed = (event: KeyboardEvent): string => {
    const before = event.timeStamp - typedRef.current.at < kWord ? typedRef.current.text : "";
    // Space chooses, unless it is in the name.
    if (event.key.length !== 1 || event.ctrlKey || event.metaKey || event.altKey || (event.key === " " && before === "")) return "";
    const text = before === event.key ? event.key : before + event.key;
    typedRef.current = { text, at: event.timeStamp };
    return text;
  };
  const press = (event: KeyboardEvent) => {
    const all = items();
    const current = all.findIndex((item) => item === document.activeElement);
    const text = typed(event);
    const next = nextIndex(event.key, current, all.length) ?? (text === "" ? undefined : indexByName(all, text, current) ?? current);
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

/** The next entry that begins with what was typed; one letter goes on to the next. */
function indexByName(items: readonly HTMLElement[], text: string, current: number): number | undefined {
  const from = text.length === 1 ? current + 1 : current;
  const order = items.map((_, i) => (from + i) % items.length);
  return order.find((i) => items[i]?.textContent.toLowerCase().startsWith(text.toLowerCase()) === true);
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
