// The parts of the cell by name, with buttons to remove them and put them back: for touch and keyboard, and for hidden parts.
import type { Body } from "../../generated/messages";

interface Props {
  readonly parts: readonly Body[];
  readonly absent: readonly string[];
  readonly act: (kind: "take" | "place", part: string) => void;
}

export function PartList({ parts, absent, act }: Props) {
  return (
    <ul className="cell-parts" id="cell-parts" aria-label="Parts">
      {parts.map(({ name, colour }) => {
        const gone = absent.includes(name);
        return (
          <li key={name} className={gone ? "is-absent" : undefined}>
            <i style={{ background: colour }} />
            <span>{name}</span>
            <button type="button" aria-label={`${gone ? "Put back" : "Take away"} ${name}`} onClick={() => act(gone ? "place" : "take", name)}>
              {gone ? "Put back" : "Take away"}
            </button>
          </li>
        );
      })}
    </ul>
  );
}
