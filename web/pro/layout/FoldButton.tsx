// The button at the border of a side panel that folds it away, or brings it back.
import type { FoldedPanel } from "../../shared/layout/panels";
import { keysOf } from "../../shared/session/shortcuts";
import { toggleFolded, useFolded } from "./panels";

const kShortcut = { left: "fold_left", right: "fold_right" } as const;

export function FoldButton({ panel }: { readonly panel: FoldedPanel }) {
  const folded = useFolded(panel);
  const keys = keysOf(kShortcut[panel]);
  return (
    <button
      type="button"
      className={`fold-button fold-${panel}`}
      aria-expanded={!folded}
      aria-label={`The ${panel} panel`}
      title={`${folded ? "Show" : "Fold away"} the ${panel} panel (${keys})`}
      aria-keyshortcuts={keys.replace("Ctrl", "Control")}
      onClick={() => toggleFolded(panel)}
    >
      {folded === (panel === "left") ? "›" : "‹"}
    </button>
  );
}
