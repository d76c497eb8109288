// Rows of the states that services had, over seconds or macro steps; a click goes to the macro step there.
import type { Scale } from "../../shared/runs/scale";
import { secondsText, type ServiceSpans } from "../../shared/runs/times";
import { view } from "../client";
import { TrackRow, visitAt } from "./Track";

interface Props {
  readonly services: readonly ServiceSpans[];
  readonly scale: Scale;
  readonly at: number | undefined;
}

/** So many states are told to who does not see them. */
const kMostTold = 20;
/** A state narrower than this part of the row has no text. */
const kText = 0.04;
const kSecond = 1e6;

type Piece = ServiceSpans["spans"][number] & { readonly left: number; readonly width: number };

const nameOfState = (state: string | undefined): string => state ?? "not available";

/** The states of which something is in the picture. */
function piecesOf({ spans }: ServiceSpans, { atTime, width }: Scale): readonly Piece[] {
  if (atTime === undefined) return [];
  return spans.flatMap((span) => {
    const [left, right] = [atTime(span.from), atTime(span.to)];
    return right <= left ? [] : [{ ...span, left: left / width, width: (right - left) / width }];
  });
}

const percent = (part: number): string => `${100 * part}%`;

/** By seconds, for as long as it is in the picture. */
function pieceText({ state, from, to, width }: Piece, scale: Scale): string {
  return `${nameOfState(state)} for ${secondsText(scale.measure === "seconds" ? width * scale.width : (to - from) / kSecond)}`;
}

export function ServiceBars({ services, scale, at }: Props) {
  const rows = services.map((each) => ({ service: each.service, pieces: piecesOf(each, scale) })).filter(({ pieces }) => pieces.length > 0);
  if (rows.length === 0) return null;
  return (
    <>
      <h4>Services</h4>
      <ul className="track-rows" aria-label="States of services over time">
        {rows.map(({ service, pieces }) => (
          <TrackRow key={service} name={service} title={`Service ${service}`} go={() => view.dispatch({ type: "page", page: "services" })}>
            <div className="track service-track" role="img" aria-label={`${service}: ${pieces.slice(0, kMostTold).map((piece) => pieceText(piece, scale)).join(", ")}`} onClick={(event) => visitAt(event, scale)}>
              {pieces.map((piece) => (
                <span
                  key={piece.from}
                  className={`service-piece${piece.state === undefined ? " is-away" : ""}`}
                  style={{ left: percent(piece.left), width: percent(piece.width) }}
                  title={pieceText(piece, scale)}
                >
                  {piece.width >= kText && nameOfState(piece.state)}
                </span>
              ))}
              {at !== undefined && <span className="service-at" style={{ left: percent(scale.at(at + 1) / scale.width) }} />}
            </div>
          </TrackRow>
        ))}
      </ul>
    </>
  );
}
