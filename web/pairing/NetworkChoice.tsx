// Which network of the server the phone is in, where it serves several.
import { texts } from "./texts";

interface Props {
  /** Addresses of the server. */
  readonly networks: readonly string[];
  readonly chosen: string | undefined;
  readonly onChoose: (network: string) => void;
}

export function NetworkChoice({ networks, chosen, onChoose }: Props) {
  if (networks.length === 0) return null;
  return (
    <label>
      {texts.fields.network}{" "}
      <select value={chosen} onChange={(event) => onChoose(event.target.value)}>
        {networks.map((each) => (
          <option key={each} value={each}>
            {new URL(each).hostname}
          </option>
        ))}
      </select>
    </label>
  );
}
