// What a person does with the phone, in three steps.
import { texts } from "./texts";

const t = texts.steps;

interface Props {
  /** A network reaches the server. */
  readonly isReached: boolean;
  /** The phone gets a code of its own, and says that it is paired. */
  readonly hasCode: boolean;
}

export function Steps({ isReached, hasCode }: Props) {
  return (
    <ol className="pairing-steps" aria-label={t.name}>
      <li>{isReached ? t.network : t.noNetwork}</li>
      <li>{t.scan}</li>
      <li>{hasCode ? t.paired : t.opened}</li>
    </ol>
  );
}
