// How much is done: a bar with its share in percent.
import { texts } from "../texts";

/** `progress`: 0..1. */
export function ProgressView({ text, progress }: { readonly text: string; readonly progress: number }) {
  const percent = texts.show.percent(Math.round(progress * 100));
  return (
    <div className="progress-bar">
      <progress aria-label={text === "" ? texts.show.progress : text} value={progress} max={1} />
      <span>{percent}</span>
    </div>
  );
}
