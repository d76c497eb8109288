// How many errors an element has, beside its name.
import { errorsText } from "../../shared/run/errorsText";
import { useErrorCount } from "./errors";

interface Props {
  readonly path: string;
  /** Nothing of what is in it is shown, so its errors count here. */
  readonly closed: boolean;
}

export function ErrorMark({ path, closed }: Props) {
  const count = useErrorCount(path, closed);
  if (count === 0) return null;
  return (
    <span className="error-mark" role="img" aria-label={errorsText(count)} title={errorsText(count)}>
      {count}
    </span>
  );
}
