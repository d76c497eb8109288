// The signs of the drawing and of the 3D view, with what they mean. pro/canvas/legend draws each as the canvas does.

export type Sign =
  | "state" | "active" | "open" | "closed" | "faulted" | "selected" | "link"
  | "port" | "port_active" | "port_bad" | "port_timed" | "port_exit"
  | "barrier" | "barrier_waiting"
  | "oracle" | "choice" | "history" | "deep history"
  | "line" | "line_fired" | "line_touched" | "line_exit" | "first"
  | "running" | "breakpoint" | "breakpoint_off" | "errors"
  | "hand" | "push" | "collision" | "balls";

export interface LegendEntry {
  readonly sign: Sign;
  readonly text: string;
}

export interface LegendGroup {
  readonly title: string;
  readonly entries: readonly LegendEntry[];
}

const entry = (sign: Sign, text: string): LegendEntry => ({ sign, text });

export const drawingLegend: readonly LegendGroup[] = [
  {
    title: "States",
    entries: [
      entry("state", "A state. Its ports are on its border."),
      entry("active", "Green: it is active now."),
      entry("open", "An open composite: its children are drawn in it. A double click with Ctrl enters it."),
      entry("closed", "A composite whose children are not drawn; + opens it."),
      entry("link", "A badge: it is a copy of that state of the library."),
      entry("selected", "Blue: it is selected."),
      entry("faulted", "Red: the run has failed here."),
      entry("errors", "So many errors in the document, here or in it."),
    ],
  },
  {
    title: "Ports and lines",
    entries: [
      entry("port", "A port: it fires when its condition is true."),
      entry("port_active", "Green: it has fired."),
      entry("port_bad", "Red: through it the run has ended badly."),
      entry("port_timed", "A clock: it fires so long after its state was entered."),
      entry("port_exit", "A port at the border of the state around: the way out of it."),
      entry("line", "Solid: from a port to the state that is entered."),
      entry("line_exit", "Dashed: an outcome that a port of the state around hears of, or that leads nowhere."),
      entry("line_fired", "Green: it was just taken."),
      entry("line_touched", "Blue: of what is selected."),
      entry("first", "A dot: here the state around begins."),
    ],
  },
  {
    title: "Barriers and oracles",
    entries: [
      entry("barrier", "A barrier: it waits for all ports that lead to it, then enters all its states at once."),
      entry("barrier_waiting", "Amber: some have arrived, so many of all."),
      entry("oracle", "Violet: an oracle decides where the state begins."),
      entry("choice", "Where it begins is computed, or asked for."),
      entry("history", "History: it begins with the child that was active last."),
      entry("deep history", "Deep history: the same in all states within."),
    ],
  },
  {
    title: "Dots",
    entries: [
      entry("running", "Green: active, in lists and in the tree."),
      entry("breakpoint", "Red: a breakpoint; here a run pauses."),
      entry("breakpoint_off", "A ring: a breakpoint that is off."),
    ],
  },
];

export const cellLegend: readonly LegendGroup[] = [
  {
    title: "Cell",
    entries: [
      entry("hand", "A hand that pulls: from the dot, where it holds, to where it pulls, with the force."),
      entry("push", "A push, the same: at the dot, in the direction of the line."),
      entry("collision", "A red ball: a collision was felt at this link or beyond, in the last 10 s."),
      entry("balls", "Three balls at the gripper: by them the camera is calibrated. Nothing touches them."),
    ],
  },
];
