// How far a task is.

interface Props {
  /** What it is the progress of, for who does not see the bar. */
  readonly name: string;
  /** 0..1 */
  readonly progress: number;
}

export function ProgressView({ name, progress }: Props) {
  return (
    <div className="progress-bar">
      <progress aria-label={name} value={progress} max={1} />
      <span>{`${Math.round(progress * 100)} %`}</span>
    </div>
  );
}
