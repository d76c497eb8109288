// Entry of the expert page.
import "@fontsource-variable/inter";
import "@fontsource/jetbrains-mono/latin-400.css";
import "@fontsource/jetbrains-mono/greek-400.css";
import "@fontsource/jetbrains-mono/latin-600.css";
import "@xyflow/react/dist/base.css";
import "./styles/tokens.css";
import "./styles/layout.css";
import "./styles/canvas.css";
import "./styles/panels.css";
import "./styles/derivation.css";
import "./styles/services.css";
import "./styles/interrupted.css";
import "./styles/help.css";
import "./styles/edit.css";
import "./styles/documents.css";
import "./styles/forms.css";
import "./styles/placing.css";
import "./styles/arguments.css";
import { createRoot } from "react-dom/client";
import { App } from "./App";
import { connect } from "./client";
import { openFromAddress } from "./edit/editing";

const root = document.getElementById("root");
if (root === null) throw new Error("the page has no #root");
createRoot(root).render(<App />);
connect();
openFromAddress();
