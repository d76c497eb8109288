// The proof of one micro step: a title, and the rows of its tree that are in view.
import type { KeyboardEvent } from "react";
import { counted } from "../../shared/counted";
import { size, summary, type ProofPath } from "../../shared/derivation/proof";
import type { ProofPlace } from "../../shared/derivation/proofRows";
import type { Derivation } from "../../generated/messages";
import { ProofNode } from "./ProofNode";
import { kRow } from "./row";

interface Props {
  readonly place: ProofPlace;
  /** How many proofs the macro step has. */
  readonly total: number;
  /** Of the micro step in its macro step, from 1. */
  readonly number: number;
  readonly root: Derivation | undefined;
  /** The rows of the tree from `first` to before `end` are in view; the two may lie beyond its ends. */
  readonly first: number;
  readonly end: number;
  /** Keys of the row whose inference is shown, and of the one that the Tab key reaches. */
  readonly picked: string | undefined;
  readonly tabbed: string | undefined;
  readonly unfolded: boolean;
  readonly onUnfold: (all: boolean) => void;
  readonly onTurn: (key: string) => void;
  readonly onPick: (path: ProofPath) => void;
  readonly onFocus: (key: string) => void;
  readonly onKey: (event: KeyboardEvent, key: string) => void;
}

export function Proof({ place: { micro, start, rows }, total, number, root, first, end, picked, tabbed, unfolded, onUnfold, onTurn, onPick, onFocus, onKey }: Props) {
  const shown = rows.map((row, index) => ({ row, index })).filter(({ row, index }) => (index >= first && index < end) || row.key === tabbed);
  return (
    <article className="proof" aria-label={`Micro step ${number}`} aria-posinset={micro + 1} aria-setsize={total} style={{ top: start * kRow, height: (rows.length + 1) * kRow }}>
      <header>
        <h3>Micro step {number}</h3>
        {root !== undefined && <span>{summary(root)}</span>}
        <button type="button" className="link" onClick={() => onUnfold(!unfolded)}>
          {unfolded ? "Fold" : "Unfold all"}
        </button>
        {root !== undefined && <small>{counted(size(root), "node")}</small>}
      </header>
      <ul role="tree" className="proof-tree" aria-label={`Proof of micro step ${number}`}>
        {shown.map(({ row, index }) => (
          <ProofNode
            key={row.key}
            row={row}
            top={(index + 1) * kRow}
            place={`${micro}:${row.key}`}
            isPicked={row.key === picked}
            isTabbed={row.key === tabbed}
            onTurn={onTurn}
            onPick={onPick}
            onFocus={onFocus}
            onKey={onKey}
          />
        ))}
      </ul>
    </article>
  );
}
