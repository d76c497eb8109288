// Entry of the display page: a display of the name in the address, `?name=`, at the place there, `?place=`, and a teach pendant.
import "@fontsource-variable/inter";
import "./tokens.css";
import "./display.css";
import "./show/show.css";
import "./move/move.css";
import "./run/run.css";
import "../stop/tokens.css";
import "../stop/stop.css";
import "../control/control.css";
import { createRoot } from "react-dom/client";
import { followControls } from "../control/page";
import { keepFocus } from "../page/keepFocus";
import { showStop } from "../stop/show";
import { App } from "./App";
import { connect, ownName } from "./client";
import { followCodes, pairByAddress } from "./pairing";
import { followPerson } from "./person";

showStop();
followControls();
keepFocus();
const element = document.getElementById("root");
if (element === null) throw new Error("the page has no #root");
const root = createRoot(element);

if (ownName === undefined) {
  root.render(<p className="notice is-bad">The name of a display has 1 to 32 letters, digits, “_” or “-”, and is not “all”.</p>);
} else {
  document.title = `${ownName} · RACE`;
  void pairByAddress().then(connect);
  followCodes();
  followPerson();
  root.render(<App />);
}
