// Yes or no.
import { useRefusal } from "../../login/rights";

interface Props {
  readonly label: string;
  readonly checked: boolean;
  readonly onChange: (checked: boolean) => void;
}

export function CheckField({ label, checked, onChange }: Props) {
  const refusal = useRefusal("edit");
  return (
    <label className="form-check" title={refusal}>
      <input type="checkbox" checked={checked} disabled={refusal !== undefined} onChange={(event) => onChange(event.target.checked)} />
      {label}
    </label>
  );
}
