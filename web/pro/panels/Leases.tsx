// What runs have reserved: which run alone may set a service in motion now.
import { byHand, reservedBy, reservedText } from "../../shared/stop/leases";
import { useStop } from "../../stop/useStop";
import { attempt } from "../client";
import { openRun } from "../runs/actions";

/** `own`: the run that is shown. */
export function Leases({ own }: { readonly own?: string }) {
  const leases = useStop((stop) => stop.leases);
  if (leases.length === 0) return null;
  return (
    <ul className="leases" aria-label="Reserved services">
      {reservedBy(leases).map((reserved) => (
        <li key={reserved.core}>
          {reservedText(reserved)}{" "}
          {byHand(reserved) ? (
            "who has the controls"
          ) : reserved.core === own ? (
            "this run"
          ) : (
            <button type="button" className="link" title="No other run moves it until this one is over" onClick={() => void attempt(() => openRun(reserved.core))}>
              run {reserved.core}
            </button>
          )}
        </li>
      ))}
    </ul>
  );
}
