// What passes on a data flow: pictures in colour or depth, of other packets what they say of themselves. The flow is
// watched as long as this is there.
import { useEffect, useRef, useState } from "react";
import type { Packet, Picture, PublishedFlow } from "../../generated/messages";
import { valueText } from "../../shared/model/describe";
import { depthScale, kFarthest, kNearest, pixels, type Sight } from "../../shared/service/pixels";
import { watchFlow } from "../client";

interface Props {
  readonly service: string;
  readonly published: PublishedFlow;
  readonly onClose: () => void;
}

const kSights: readonly { readonly sight: Sight; readonly name: string }[] = [
  { sight: "colour", name: "Colour" },
  { sight: "depth", name: "Depth" },
];

const metres = (mm: number) => `${(mm / 1000).toFixed(1)} m`;

export function FlowWatch({ service, published, onClose }: Props) {
  const [sight, setSight] = useState<Sight>("colour");
  const [packet, setPacket] = useState<Packet>();
  const name = `${service}.${published.flow}`;
  const picture = packet?.picture;
  useEffect(() => watchFlow(service, published.flow, setPacket), [service, published.flow]);
  return (
    <section className="flow-watch" aria-label={`Packets of ${name}`}>
      <header>
        <h3>{name}</h3>
        {picture !== undefined && (
          <fieldset aria-label="What is shown">
            {kSights.map((each) => (
              <label key={each.sight}>
                <input type="radio" name={`sight of ${name}`} checked={sight === each.sight} onChange={() => setSight(each.sight)} />
                {each.name}
              </label>
            ))}
          </fieldset>
        )}
        <button aria-label={`Stop watching ${name}`} title="Stop watching (Esc)" onClick={onClose}>
          ×
        </button>
      </header>
      {packet === undefined && <p className="quiet flow-wait">Waiting for a packet…</p>}
      {picture !== undefined && <PictureView service={service} picture={picture} sight={sight} />}
      {packet !== undefined && picture === undefined && <HeaderTable header={packet.header} />}
      <footer>
        <span className="flow-time">{packet === undefined ? "" : `${packet.time.toFixed(2)} s`}</span>
        <span>{published.rate_hz > 0 ? `${published.rate_hz.toFixed(1)} packets/s of world time` : "no packets"}</span>
        {picture !== undefined && sight === "depth" && (
          <span className="flow-scale">
            {metres(kNearest)} <i style={{ background: depthScale }} /> {metres(kFarthest)}; dark: not measured
          </span>
        )}
      </footer>
    </section>
  );
}

interface PictureProps {
  readonly service: string;
  readonly picture: Picture;
  readonly sight: Sight;
}

function PictureView({ service, picture, sight }: PictureProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    canvas.current?.getContext("2d")?.putImageData(new ImageData(pixels(picture, sight), picture.width, picture.height), 0, 0);
  }, [picture, sight]);
  const label = `What ${service} sees, ${sight === "depth" ? "depth in false colours" : "in colour"}`;
  return <canvas ref={canvas} width={picture.width} height={picture.height} role="img" aria-label={label} />;
}

/** The newest packet's header; its bytes stay on the server. */
function HeaderTable({ header }: Pick<Packet, "header">) {
  const fields = typeof header === "object" && header !== null && !Array.isArray(header) ? Object.entries(header) : [["packet", header] as const];
  return (
    <dl className="pairs flow-header" aria-label="Newest packet">
      {fields.map(([name, value]) => (
        <div key={name}>
          <dt>{name}</dt>
          <dd>{valueText(value)}</dd>
        </div>
      ))}
    </dl>
  );
}
