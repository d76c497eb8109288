// The packets of a data flow: pictures in colour or depth, of other packets the header. The flow is
// watched while this component is mounted.
import { useEffect, useRef, useState } from "react";
import type { Packet, Picture, PublishedFlow } from "../../generated/messages";
import { valueText } from "../../shared/model/describe";
import { depthScale, kFarthest, kNearest, pixels, type ImageKind } from "../../shared/service/pixels";
import { watchFlow } from "../client";

interface Props {
  readonly service: string;
  readonly published: PublishedFlow;
  readonly onClose: () => void;
}

const kImageKinds: readonly { readonly kind: ImageKind; readonly name: string }[] = [
  { kind: "colour", name: "Colour" },
  { kind: "depth", name: "Depth" },
];

const metres = (mm: number) => `${(mm / 1000).toFixed(1)} m`;

export function FlowWatch({ service, published, onClose }: Props) {
  const [kind, setKind] = useState<ImageKind>("colour");
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
            {kImageKinds.map((each) => (
              <label key={each.kind}>
                <input type="radio" name={`image kind of ${name}`} checked={kind === each.kind} onChange={() => setKind(each.kind)} />
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
      {picture !== undefined && <PictureView service={service} picture={picture} kind={kind} />}
      {packet !== undefined && picture === undefined && <HeaderTable header={packet.header} />}
      <footer>
        <span className="flow-time">{packet === undefined ? "" : `${packet.time.toFixed(2)} s`}</span>
        <span>{published.rate_hz > 0 ? `${published.rate_hz.toFixed(1)} packets/s of world time` : "no packets"}</span>
        {picture !== undefined && kind === "depth" && (
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
  readonly kind: ImageKind;
}

function PictureView({ service, picture, kind }: PictureProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    canvas.current?.getContext("2d")?.putImageData(new ImageData(pixels(picture, kind), picture.width, picture.height), 0, 0);
  }, [picture, kind]);
  const label = `What ${service} sees, ${kind === "depth" ? "depth in false colours" : "in colour"}`;
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
