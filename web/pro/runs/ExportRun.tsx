// The export of a stored run as an MCAP file: how far it is, and what is missing in the file. It begins when this is shown, and ends when it is not.
import { useEffect, useState } from "react";
import { messageOf } from "../../shared/messageOf";

interface Props {
  readonly id: string;
  readonly close: () => void;
}

/** How far it is, from 0 to 1; or what it came to. */
type Shown = { readonly part: number } | { readonly notes: readonly string[] } | { readonly failed: string };

export function ExportRun({ id, close }: Props) {
  const [shown, show] = useState<Shown>({ part: 0 });
  useEffect(() => {
    const ending = new AbortController();
    const tell = (now: Shown) => {
      if (!ending.signal.aborted) show(now);
    };
    // Its code is loaded now, as few need it.
    import("./exportMcap")
      .then(({ exportMcap }) => exportMcap(id, ending.signal, (part) => tell({ part })))
      .then(
        (notes) => tell({ notes }),
        (error: unknown) => tell({ failed: messageOf(error) }),
      );
    return () => ending.abort();
  }, [id]);
  const isAtWork = "part" in shown;
  return (
    <div className="export-run" role="group" aria-label={`Export of run ${id}`}>
      {isAtWork && <progress value={shown.part} aria-label={`Exporting run ${id}`} />}
      {"failed" in shown ? (
        <p className="bad" role="alert">
          {shown.failed}
        </p>
      ) : (
        <p role="status">{isAtWork ? `Exporting run ${id}…` : [`Saved as run-${id}.mcap.`, ...shown.notes].join(" ")}</p>
      )}
      <button type="button" autoFocus onClick={close}>
        {isAtWork ? "Cancel" : "Close"}
      </button>
    </div>
  );
}
