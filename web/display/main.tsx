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
import { texts } from "./texts";
import { WrongName } from "./WrongName";

showStop();
followControls();
keepFocus();
const element = document.getElementById("root");
if (element === null) throw new Error("the page has no #root");
const root = createRoot(element);

if (ownName === undefined) {
  root.render(<WrongName />);
} else {
  document.title = texts.frame.title(ownName);
  void pairByAddress().then(connect);
  followCodes();
  followPerson();
  root.render(<App />);
}
