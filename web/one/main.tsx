// Entry of the novice page.
import "@fontsource-variable/inter";
import "../pro/styles/tokens.css";
import "../pro/styles/pairing.css";
import "../stop/tokens.css";
import "../stop/stop.css";
import "../control/control.css";
import "./one.css";
import { createRoot } from "react-dom/client";
import { followControls } from "../control/page";
import { keepFocus } from "../page/keepFocus";
import { showStop } from "../stop/show";
import { App, FirstLogin } from "./App";
import { access, connect } from "./client";
import { followAddress } from "./place";

showStop();
followControls();
keepFocus();
const element = document.getElementById("root");
if (element === null) throw new Error("the page has no #root");
const root = createRoot(element);
root.render(<FirstLogin />);
void access.known().then(() => {
  connect();
  followAddress();
  root.render(<App />);
});
