// The frame of the page: what is above on all views, and the view.
import { Login } from "../display/Login";
import { ControlBar } from "../control/ControlBar";
import { SpeedOverride } from "../control/SpeedOverride";
import { StoppedBanner } from "../stop/StoppedBanner";
import { Applications } from "./Applications";
import { Build } from "./Build";
import { access, dismissProblem, logIn, ownControls, robotSpeed, useLogin, useRefusal, useSession } from "./client";
import { Guide } from "./guide/Guide";
import { useLeft } from "./guide/useLeft";
import { Head } from "./Head";
import { LeaveQuestion } from "./LeaveQuestion";
import { useIsRun, usePlace } from "./place";
import { RunView } from "./run/RunView";
import { texts } from "./texts";
import { Told } from "./Told";

export function App() {
  const asked = useLogin((login) => login.asked);
  if (asked) return <Login logIn={logIn} />;
  return <Page />;
}

/** Before it is known who uses the page. */
export function FirstLogin() {
  const asked = useLogin((login) => login.asked);
  return asked ? <Login logIn={logIn} /> : null;
}

function Page() {
  const [edit, view] = [usePlace((place) => place.edit), usePlace((place) => place.view)];
  const guide = usePlace((place) => place.guide);
  const isRun = useIsRun();
  useLeft(guide !== undefined);
  const lost = useSession((s) => s.connection === "lost");
  const away = useSession((s) => (s.connection === "open" ? undefined : texts.frame.away));
  const [reset, take, answer, speed] = [useRefusal("reset_stop"), useRefusal("take_controls"), useRefusal("answer_control"), useRefusal("set_speed")];
  return (
    <div className={`one${lost ? " is-lost" : ""}`}>
      <Head />
      <StoppedBanner refusal={away ?? reset} fetcher={access.fetch} />
      <ControlBar always address={ownControls} refusal={away ?? take} refusalToAnswer={away ?? answer} fetcher={access.fetch} speed={robotSpeed}>
        {isRun ? undefined : <SpeedOverride speed={robotSpeed} refusal={away ?? speed} />}
      </ControlBar>
      {lost && (
        <p className="notice server-lost" role="alert" aria-label={texts.frame.lostTitle}>
          <strong>{texts.frame.lostTitle}</strong>
          <span>{texts.frame.lost}</span>
        </p>
      )}
      <Problem />
      {guide !== undefined ? <Guide step={guide} /> : edit === undefined ? <Applications /> : view === "run" ? <RunView name={edit} /> : <Build name={edit} />}
      <Told />
      <LeaveQuestion />
    </div>
  );
}

function Problem() {
  const text = useSession((s) => s.problem);
  if (text === undefined) return null;
  return (
    <p className="notice is-bad" role="alert">
      <span>{text}</span>
      <button type="button" className="plain" aria-label={texts.frame.closeMessage} onClick={dismissProblem}>
        ✕
      </button>
    </p>
  );
}
