// How much is done: a bar with its share in percent.

/** `progress`: 0..1. */
export function ProgressView({ text, progress }: { readonly text: string; readonly progress: number }) {
  const percent = `${Math.round(progress * 100)} %`;
  return (
    <div className="progress-bar">
      <progress aria-label={text === "" ? "Progress" : text} value={progress} max={1} />
      <span>{percent}</span>
    </div>
  );
}
