// The whole page: who has the controls, how the connection is, one of three views, and the way to the others.
import { ControlBar } from "../control/ControlBar";
import { StoppedBanner } from "../stop/StoppedBanner";
import { access, display, logIn, ownControls, robotSpeed, useDisplay, useLogin, useRefusal, useSession } from "./client";
import { Login } from "./Login";
import { LostServer } from "./LostServer";
import { MoveView } from "./move/MoveView";
import { PairingNotice } from "./PairingNotice";
import { usePlace } from "./place";
import { RunView } from "./run/RunView";
import { ShowView } from "./show/ShowView";
import { Asking, Status } from "./Status";
import { Tabs } from "./Tabs";
import { texts } from "./texts";

const kViews = { show: ShowView, move: MoveView, run: RunView } as const;

export function App() {
  const asks = useLogin(({ asked }) => asked);
  return asks ? <Login logIn={logIn} /> : <Page />;
}

function Page() {
  const view = usePlace((place) => place.view);
  const connection = useDisplay((page) => page.connection);
  const isLost = useSession((now) => now.connection === "lost");
  const lost = connection === "open" ? undefined : texts.frame.away;
  const [reset, take, answer] = [useRefusal("reset_stop"), useRefusal("take_controls"), useRefusal("answer_control")];
  const View = kViews[view];
  return (
    <>
      <StoppedBanner refusal={lost ?? reset} fetcher={access.fetch} />
      <ControlBar always address={ownControls} refusal={lost ?? take} refusalToAnswer={lost ?? answer} fetcher={access.fetch} speed={robotSpeed} />
      <div className="display" data-connection={connection}>
        <Status />
        <PairingNotice />
        {isLost && <LostServer />}
        {view === "run" && <Asking />}
        <main key={view} className={`view-${view}`} inert={isLost}>
          <View />
        </main>
      </div>
      <Tabs view={view} name={display.get().name} />
    </>
  );
}
