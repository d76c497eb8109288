// What passes on a data flow, as a picture in colour or depth. The flow is watched as long as this is there.
import { useEffect, useRef, useState } from "react";
import type { Packet } from "../../shared/messages/packet";
import type { Published } from "../../shared/messages/service";
import { depthScale, kFarthest, kNearest, pixels, type Sight } from "../../shared/service/pixels";
import { watchFlow } from "../client";

interface Props {
  readonly service: string;
  readonly published: Published;
  readonly onClose: () => void;
}

const kSights: readonly { readonly sight: Sight; readonly name: string }[] = [
  { sight: "colour", name: "Colour" },
  { sight: "depth", name: "Depth" },
];

const metres = (mm: number) => `${(mm / 1000).toFixed(1)} m`;

export function FlowPicture({ service, published, onClose }: Props) {
  const [sight, setSight] = useState<Sight>("colour");
  const [packet, setPacket] = useState<Packet>();
  const canvas = useRef<HTMLCanvasElement>(null);
  const name = `${service}.${published.flow}`;
  const picture = packet?.picture;
  useEffect(() => watchFlow(service, published.flow, setPacket), [service, published.flow]);
  useEffect(() => {
    if (picture === undefined) return;
    canvas.current?.getContext("2d")?.putImageData(new ImageData(pixels(picture, sight), picture.width, picture.height), 0, 0);
  }, [picture, sight]);
  return (
    <section className="flow-picture" aria-label={`Picture of ${name}`}>
      <header>
        <h3>{name}</h3>
        <fieldset aria-label="What is shown">
          {kSights.map((each) => (
            <label key={each.sight}>
              <input type="radio" name={`sight of ${name}`} checked={sight === each.sight} onChange={() => setSight(each.sight)} />
              {each.name}
            </label>
          ))}
        </fieldset>
        <button aria-label={`Stop watching ${name}`} title="Stop watching (Esc)" onClick={onClose}>
          ×
        </button>
      </header>
      {picture !== undefined && (
        <canvas ref={canvas} width={picture.width} height={picture.height} role="img" aria-label={`What ${service} sees, ${sight === "depth" ? "depth in false colours" : "in colour"}`} />
      )}
      {picture === undefined && <p className="quiet flow-wait">{packet === undefined ? "Waiting for a packet…" : "The packets of this flow are no pictures."}</p>}
      <footer>
        <span className="flow-time">{packet === undefined ? "" : `${packet.time.toFixed(2)} s`}</span>
        <span>{published.rate_hz > 0 ? `${published.rate_hz.toFixed(1)} packets/s of world time` : "no packets"}</span>
        {sight === "depth" && (
          <span className="flow-scale">
            {metres(kNearest)} <i style={{ background: depthScale }} /> {metres(kFarthest)}; dark: not measured
          </span>
        )}
      </footer>
    </section>
  );
}
