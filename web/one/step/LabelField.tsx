// The label of a part, or several: first those that the camera sees now, then others that are known; any other is typed.
import type { ExactJson } from "../../shared/edit/exact";
import { Chips } from "./Chips";
import { useLabels } from "./known";
import { SightFrame } from "./SightFrame";
import { TextField } from "./TextField";
import { TextsField } from "./TextsField";

interface Common {
  /** The step that is open: for each the camera is asked anew. */
  readonly step: string;
  readonly id: string;
  readonly label: string;
  readonly disabled: boolean;
  readonly set: (value: ExactJson) => void;
}

export function LabelField({ step, value, ...common }: Common & { readonly value: string }) {
  const labels = useLabels(step);
  const { id, disabled, set } = common;
  return (
    <div className="texts">
      <SightFrame labels={labels}>
        <Chips texts={labels.seen} chosen={[value]} disabled={disabled} onChange={set} oneOf={`seen-${id}`} />
      </SightFrame>
      <TextField {...common} value={value} isLong={false} known={[...labels.seen, ...labels.others]} />
    </div>
  );
}

export function LabelsField({ step, values, ...common }: Common & { readonly values: readonly string[] }) {
  const labels = useLabels(step);
  return (
    <TextsField {...common} values={values} known={labels.others} apart={{ texts: labels.seen, frame: (chips) => <SightFrame labels={labels}>{chips}</SightFrame> }} />
  );
}
