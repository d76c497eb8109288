// Some of the ports of a state, or any of them.
import type { State } from "../../../shared/model/model";
import { CheckField } from "./CheckField";

interface Props {
  readonly label: string;
  readonly state: State;
  /** Nothing: any. */
  readonly names: readonly string[] | undefined;
  readonly onChange: (names: readonly string[] | undefined) => void;
}

export function PortChecks({ label, state, names, onChange }: Props) {
  const ports = [...new Set([...state.ports.map(({ name }) => name), ...(names ?? [])])];
  const put = (name: string, checked: boolean) => onChange(ports.filter((port) => (port === name ? checked : names?.includes(port) === true)));
  return (
    <fieldset className="form-checks">
      <legend>{label}</legend>
      <CheckField label="any port" checked={names === undefined} onChange={(any) => onChange(any ? undefined : [])} />
      {names !== undefined && ports.map((port) => <CheckField key={port} label={port} checked={names.includes(port)} onChange={(checked) => put(port, checked)} />)}
    </fieldset>
  );
}
