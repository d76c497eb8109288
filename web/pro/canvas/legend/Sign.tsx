// A sign of the legend, with the classes, components and colours by which the canvas draws it.
import type { ReactNode } from "react";
import { assertNever } from "../../../shared/assertNever";
import type { Sign as SignName } from "../../../shared/help/legend";
import { Icon } from "../../panels/Icon";
import { LineShape } from "../ModelLine";
import { kSigns } from "../StateNode";

export function Sign({ sign }: { readonly sign: SignName }) {
  switch (sign) {
    case "state":
      return <State />;
    case "active":
      return <State look="is-active" />;
    case "open":
      return (
        <State look="is-open" toggle="−">
          <i className="state" />
        </State>
      );
    case "closed":
      return <State toggle="+" />;
    case "faulted":
      return <State look="is-faulted" />;
    case "selected":
      return <State look="is-selected" />;
    case "link":
      return <State badge="Part" />;
    case "oracle":
      return <State badge="oracle" badgeLook="is-oracle" />;
    case "choice":
    case "history":
    case "deep history":
      return (
        <div className="state is-dispatcher">
          <div className="state-head">
            <span className="state-name">{kSigns[sign]}</span>
          </div>
        </div>
      );
    case "port":
      return <Port />;
    case "port_active":
      return <Port look="is-active" />;
    case "port_bad":
      return <Port look="is-active ends-badly" />;
    case "port_timed":
      return <Port timed />;
    case "port_exit":
      return <Port look="is-exit" />;
    case "barrier":
      return <span className="barrier" />;
    case "barrier_waiting":
      return (
        <span className="barrier is-waiting">
          <span className="barrier-note">1/2</span>
        </span>
      );
    case "line":
      return <Line kind="transition" />;
    case "line_exit":
      return <Line kind="exit" />;
    case "line_fired":
      return <Line kind="transition" state="fired" />;
    case "line_touched":
      return <Line kind="transition" touched />;
    case "first":
      return <Line kind="first" />;
    case "running":
      return <i className="dot" />;
    case "breakpoint":
      return <i className="breakpoint-dot" />;
    case "breakpoint_off":
      return <i className="breakpoint-dot is-off" />;
    case "errors":
      return <span className="error-mark">2</span>;
    case "hand":
      return <Touch force="25 N" dotted />;
    case "push":
      return <Touch force="25 N" />;
    case "collision":
      return (
        <svg className="legend-collision" viewBox="0 0 60 24">
          <circle cx={30} cy={12} r={9} />
        </svg>
      );
    case "balls":
      return (
        <svg className="legend-balls" viewBox="0 0 60 24">
          {[14, 30, 48].map((x, i) => (
            <circle key={x} cx={x} cy={[8, 17, 12][i]} r={6} />
          ))}
        </svg>
      );
    default:
      return assertNever(sign);
  }
}

interface StateProps {
  readonly look?: string;
  readonly toggle?: string;
  readonly badge?: string;
  readonly badgeLook?: string;
  readonly children?: ReactNode;
}

function State({ look = "", toggle, badge, badgeLook = "", children }: StateProps) {
  return (
    <div className={`state ${look}`}>
      <div className="state-head">
        <span className="state-name">{badge === undefined ? "Grasp" : "A"}</span>
        {badge !== undefined && <span className={`state-badge ${badgeLook}`}>{badge}</span>}
        {toggle !== undefined && <span className="state-toggle">{toggle}</span>}
      </div>
      {children}
    </div>
  );
}

function Port({ look = "", timed = false }: { readonly look?: string; readonly timed?: boolean }) {
  return (
    <div className={`port ${look}`}>
      <span className="port-name">
        {timed && <Icon name="clock" />}
        {timed ? "late" : "success"}
      </span>
    </div>
  );
}

const kWay = [{ x: 6, y: 12 }, { x: 62, y: 12 }];

function Line({ kind, state = "idle", touched = false }: { readonly kind: "transition" | "exit" | "first"; readonly state?: "idle" | "fired"; readonly touched?: boolean }) {
  return (
    <svg viewBox="0 0 68 24" width="68" height="24">
      <LineShape id={`legend-${kind}-${state}`} kind={kind} points={kWay} state={state} touched={touched} />
    </svg>
  );
}

/** As HandLines draws it: a push has no target, its line is as long as it is strong. */
function Touch({ force, dotted = false }: { readonly force: string; readonly dotted?: boolean }) {
  return (
    <span className="legend-touch">
      <svg viewBox="0 0 34 24" width="34" height="24">
        <path d={dotted ? "M5 18L31 6" : "M5 18L20 11"} />
        <circle cx={5} cy={18} r={3.5} />
      </svg>
      <span className="cell-force">{force}</span>
    </span>
  );
}
