// The signs with what they mean, for the panel over the canvas, that of the cell, and the help.
import type { LegendGroup } from "../../../shared/help/legend";
import { Sign } from "./Sign";

export function LegendLists({ groups }: { readonly groups: readonly LegendGroup[] }) {
  return (
    <div className="legend-lists">
      {groups.map(({ title, entries }) => (
        <div key={title} role="group" aria-label={title}>
          <h3>{title}</h3>
          <dl>
            {entries.map(({ sign, text }) => (
              <div key={sign}>
                <dt aria-hidden="true" data-sign={sign}>
                  <Sign sign={sign} />
                </dt>
                <dd>{text}</dd>
              </div>
            ))}
          </dl>
        </div>
      ))}
    </div>
  );
}
