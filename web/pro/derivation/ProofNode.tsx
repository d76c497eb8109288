// A node of a derivation as a row: all fields that it holds; its premises are the rows below it.
import type { KeyboardEvent } from "react";
import { premiseCount, rowParts, subjectText, type ProofPath, type RowPart } from "../../shared/derivation/proof";
import type { ProofRow } from "../../shared/derivation/proofRows";
import type { Derivation } from "../../generated/messages";
import { kLevel } from "./row";

interface Props {
  readonly row: ProofRow;
  /** Below the top of its proof [px]. */
  readonly top: number;
  /** Names the row among all of the macro step, for the focus. */
  readonly place: string;
  readonly isPicked: boolean;
  readonly isTabbed: boolean;
  readonly onTurn: (key: string) => void;
  readonly onPick: (path: ProofPath) => void;
  readonly onFocus: (key: string) => void;
  readonly onKey: (event: KeyboardEvent, key: string) => void;
}

export function ProofNode({ row: { node, path, key, position, siblings, open }, top, place, isPicked, isTabbed, onTurn, onPick, onFocus, onKey }: Props) {
  const depth = path.length;
  return (
    <li
      role="treeitem"
      aria-level={depth + 1}
      aria-posinset={position}
      aria-setsize={siblings}
      aria-expanded={open}
      aria-selected={isPicked}
      aria-label={`${node.rule} (${node.equation}) ${subjectText(node)}`}
      style={{ top, paddingLeft: depth * kLevel, backgroundSize: `${depth * kLevel}px 100%` }}
    >
      <div className={`proof-line${isPicked ? " is-picked" : ""}`}>
        {open === undefined ? (
          <span className="fold" aria-hidden="true" />
        ) : (
          <button type="button" tabIndex={-1} className="fold" aria-label={`${open ? "Fold" : "Unfold"} ${node.rule}`} onClick={() => onTurn(key)}>
            {open ? "▾" : "▸"}
          </button>
        )}
        <button
          type="button"
          className="proof-row"
          data-proof={place}
          tabIndex={isTabbed ? 0 : -1}
          onClick={() => onPick(path)}
          onDoubleClick={() => open !== undefined && onTurn(key)}
          onFocus={() => onFocus(key)}
          onKeyDown={(event) => onKey(event, key)}
        >
          {rowParts(node).map((part) => (
            <span key={part.kind} className={partClass(part, node)} title={part.full ?? part.text}>
              {part.text}
            </span>
          ))}
          {open === false && <small>{premiseCount(node)}</small>}
        </button>
      </div>
    </li>
  );
}

function partClass(part: RowPart, node: Derivation): string {
  if (part.kind === "rule") return `rule rule-${layerOf(node.rule)}`;
  const truth = part.kind === "value" && (node.value === null || typeof node.value === "boolean");
  return truth ? `value is-${String(node.value)}` : part.kind;
}

/** Colour group of a rule: moves of the micro layer, activation, deactivation, the rest. */
function layerOf(rule: string): "micro" | "up" | "down" | "atomic" {
  if (/^(PTrigger|PTrans|SProp|Micro)/.test(rule)) return "micro";
  if (/^(SAct|BAct|Act$)/.test(rule)) return "up";
  return /^(SDeact|BDeact|Deact)/.test(rule) ? "down" : "atomic";
}
