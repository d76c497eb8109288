// One derivation as a tree that can be unfolded: a row shows all fields of its node, with its premises below in order.
import { useState, type KeyboardEvent } from "react";
import { notable, premiseCount, rowParts, subjectText, type ProofPath, type RowPart } from "../../shared/derivation/proof";
import type { Derivation } from "../../generated/messages";

interface Props {
  readonly root: Derivation;
  readonly micro: number;
  readonly picked: ProofPath | undefined;
  readonly onPick: (path: ProofPath) => void;
  /** Unfolds every node, not only those at which something happens. */
  readonly unfolded: boolean;
}

export function ProofTree({ root, micro, picked, onPick, unfolded }: Props) {
  return (
    <ul role="tree" className="proof-tree" aria-label={`Proof of micro step ${micro}`}>
      <ProofNode node={root} path={[]} picked={picked} onPick={onPick} unfolded={unfolded} />
    </ul>
  );
}

interface NodeProps {
  readonly node: Derivation;
  readonly path: ProofPath;
  readonly picked: ProofPath | undefined;
  readonly onPick: (path: ProofPath) => void;
  readonly unfolded: boolean;
}

/** Moves the focus among the rows of a tree, in the order in which they are seen. */
function move(row: HTMLElement, by: 1 | -1): void {
  const rows = [...(row.closest(".derivation")?.querySelectorAll<HTMLElement>(".proof-row") ?? [])];
  rows[rows.indexOf(row) + by]?.focus();
}

function ProofNode({ node, path, picked, onPick, unfolded }: NodeProps) {
  const [open, setOpen] = useState(() => unfolded || notable(node));
  const folds = node.premises.length > 0;
  const selected = picked !== undefined && picked.join() === path.join();
  const press = (event: KeyboardEvent<HTMLButtonElement>) => {
    const row = event.currentTarget;
    if (event.key === "ArrowRight" && folds) setOpen(true);
    else if (event.key === "ArrowLeft" && folds) setOpen(false);
    else if (event.key === "ArrowDown") move(row, 1);
    else if (event.key === "ArrowUp") move(row, -1);
    else return;
    event.preventDefault();
  };
  return (
    <li role="treeitem" aria-expanded={folds ? open : undefined} aria-selected={selected} aria-label={`${node.rule} (${node.equation}) ${subjectText(node)}`}>
      <div className={`proof-line${selected ? " is-picked" : ""}`}>
        {folds ? (
          <button type="button" tabIndex={-1} className="fold" aria-label={`${open ? "Fold" : "Unfold"} ${node.rule}`} onClick={() => setOpen(!open)}>
            {open ? "▾" : "▸"}
          </button>
        ) : (
          <span className="fold" aria-hidden="true" />
        )}
        <button type="button" className="proof-row" onClick={() => onPick(path)} onDoubleClick={() => setOpen(!open)} onKeyDown={press}>
          {rowParts(node).map((part) => (
            <span key={part.kind} className={partClass(part, node)} title={part.full ?? part.text}>
              {part.text}
            </span>
          ))}
          {folds && !open && <small>{premiseCount(node)}</small>}
        </button>
      </div>
      {folds && open && (
        <ul role="group">
          {node.premises.map((premise, i) => (
            <ProofNode key={i} node={premise} path={[...path, i]} picked={picked} onPick={onPick} unfolded={unfolded} />
          ))}
        </ul>
      )}
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
