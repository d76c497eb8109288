// The proofs of a macro step, one below the other: the rows in view, and the one with the focus.
import { useEffect, useMemo, useRef, useState, type KeyboardEvent } from "react";
import { microNumber, type ProofPath } from "../../shared/derivation/proof";
import { kAsFirst, keyOf, nextNode, placeProofs, proofRows, rowOf, turn, type Folding, type ProofCursor } from "../../shared/derivation/proofRows";
import type { TraceStep } from "../../generated/messages";
import type { WantedInference } from "../../shared/session/view";
import { showRow, useFocusWhenShown } from "../panels/showRow";
import { useRowsInView } from "../panels/useRowsInView";
import { Proof } from "./Proof";
import { kRow } from "./row";

/** Rows in view beside one that was asked for. */
const kBeside = 4;

/** An inference of a macro step. */
export interface Picked {
  readonly micro: number;
  readonly path: ProofPath;
}

/** What is folded, by the place of the micro step in the list. */
export type Foldings = ReadonlyMap<number, Folding>;

interface Props {
  readonly step: TraceStep;
  readonly picked: Picked;
  /** What was asked for, and is picked at first. */
  readonly wanted: WantedInference | undefined;
  readonly foldings: Foldings;
  readonly onPick: (picked: Picked) => void;
  readonly onFold: (foldings: Foldings) => void;
}

export function ProofList({ step, picked, wanted, foldings, onPick, onFold }: Props) {
  const [cursor, setCursor] = useState<ProofCursor>();
  const list = useRef<HTMLDivElement>(null);
  const focusWhenShown = useFocusWhenShown(list);
  const { places, count } = useMemo(() => placeProofs(step.micro.map((root, i) => proofRows(root, foldings.get(i) ?? kAsFirst))), [step, foldings]);
  const reachedRef = useRef<WantedInference | number>(undefined);
  useEffect(() => {
    const asked = wanted ?? step.step;
    const row = wanted === undefined ? 0 : rowOf(places, { micro: picked.micro, key: keyOf(picked.path) });
    // Of a macro step that comes in parts, it may be in a later one.
    if (row === undefined || reachedRef.current === asked) return;
    reachedRef.current = asked;
    list.current?.closest(".proofs")?.scrollTo({ top: 0 });
    if (wanted !== undefined && wanted.micro > 0) showRow(list.current, ".proofs", row, kRow, kBeside);
  }, [step.step, wanted, places, picked]);
  const inView = useRowsInView(list, ".proofs", count, kRow);
  // The row with the focus stays in the page, else the focus would be lost.
  const candidates = [cursor, { micro: picked.micro, key: keyOf(picked.path) }, { micro: 0, key: "" }];
  const tabbed = candidates.find((each) => each !== undefined && rowOf(places, each) !== undefined);

  const fold = (micro: number, folding: Folding) => onFold(new Map(foldings).set(micro, folding));
  const turnAt = ({ micro, key }: ProofCursor) => fold(micro, turn(foldings.get(micro) ?? kAsFirst, key));
  const press = (event: KeyboardEvent, at: ProofCursor) => {
    const open = places[at.micro]?.rows.find((row) => row.key === at.key)?.open;
    if (event.key === "ArrowRight" && open === false) turnAt(at);
    else if (event.key === "ArrowLeft" && open === true) turnAt(at);
    else if (event.key === "ArrowDown") move(at, 1);
    else if (event.key === "ArrowUp") move(at, -1);
    else return;
    event.preventDefault();
  };
  const move = (from: ProofCursor, by: 1 | -1) => {
    const to = nextNode(places, from, by);
    const row = to === undefined ? undefined : rowOf(places, to);
    if (to === undefined || row === undefined) return;
    focusWhenShown(`[data-proof="${to.micro}:${to.key}"]`);
    setCursor(to);
    showRow(list.current, ".proofs", row, kRow);
  };

  const shown = places.filter(({ micro, start, rows }) => (start < inView.end && start + rows.length >= inView.first) || micro === tabbed?.micro);
  return (
    <div className="proof-list" ref={list} style={{ height: count * kRow }}>
      {shown.map((place) => (
        <Proof
          key={place.micro}
          place={place}
          total={places.length}
          number={microNumber((step.first ?? 0) + place.micro)}
          root={step.micro[place.micro]}
          first={inView.first - place.start - 1}
          end={inView.end - place.start - 1}
          picked={picked.micro === place.micro ? keyOf(picked.path) : undefined}
          tabbed={tabbed?.micro === place.micro ? tabbed.key : undefined}
          unfolded={foldings.get(place.micro)?.all === true}
          onUnfold={(all) => fold(place.micro, { all, turned: new Set() })}
          onTurn={(key) => turnAt({ micro: place.micro, key })}
          onPick={(path) => onPick({ micro: place.micro, path })}
          onFocus={(key) => setCursor({ micro: place.micro, key })}
          onKey={(event, key) => press(event, { micro: place.micro, key })}
        />
      ))}
    </div>
  );
}
