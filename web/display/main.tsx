// Entry of the display page: a display of the name in the address, `?name=`, at the place there, `?place=`.
import "@fontsource-variable/inter";
import "./tokens.css";
import "./display.css";
import "../stop/tokens.css";
import "../stop/stop.css";
import "../control/control.css";
import { createRoot } from "react-dom/client";
import { nameOf, placeOf } from "../shared/display/page";
import { App } from "./App";
import { connect } from "./client";
import { followControls } from "../control/page";
import { showStop } from "../stop/show";
import { Login } from "./Login";

showStop();
followControls();
const element = document.getElementById("root");
if (element === null) throw new Error("the page has no #root");
const root = createRoot(element);

const name = nameOf(location.search);
if (name === undefined) {
  root.render(<p className="notice is-bad">The name of a display has 1 to 32 letters, digits, “_” or “-”, and is not “all”.</p>);
} else {
  document.title = `${name} · RACE Display`;
  connect(
    name,
    placeOf(location.search),
    (page, actions) => root.render(<App page={page} actions={actions} />),
    (logIn) => root.render(<Login logIn={logIn} />),
  );
}
