// How tasks run, are watched, and are changed (core/SEMANTICS.md, sections 3, 8 to 10).
import { heading, list, terms, text, type Topic } from "./blocks";

const group = "Runs" as const;

export const running: readonly Topic[] = [
  {
    id: "run", title: "Making and starting a run", group,
    blocks: [
      text("A run executes a document as it is in one revision, with arguments for the parameters of its root. It is made by Load (or F5 in the editor) and started by Start (F5): only then anything moves. Whatever starts it, key or button, asks before that, once for a document."),
      list("Pause (F7) stops the task between two micro steps. What services do goes on: a robot that moves ends its motion.", "Stop (F8) ends the run. No exit function is executed; the safe operations of the services are called.", "A document with errors is a draft: it is stored, but cannot be run."),
      heading("STOP"),
      list("STOP (F3, or the red button on every page) stops the whole cell: the robot brakes, all runs end, and nothing moves until the reset. It needs no login, and works while you type.", "Reset… in the red banner is for operators. The reset starts nothing: runs that the stop has ended are over.", "A run reserves what it moves, such as the robot, until it is over; calls of other runs are refused as `leased`."),
      text("STOP of this program is not a safety function. The emergency stop of the robot is."),
    ],
  },
  {
    id: "steps", title: "Macro steps and micro steps", group,
    blocks: [
      text("Nothing happens in a run without an input: an event, a response, the start. One input is one macro step. It consists of micro steps: in each, conditions are tested, ports fire, states are left and entered, functions are executed. The macro step is over when nothing more changes; then the next input is taken."),
      text("So all that happens because of one input is done before the next input is seen, and a run with the same inputs does the same, bit for bit."),
      terms(["Micro step (F4)", "one micro step, also within a macro step"], ["Macro step (Shift+F4)", "to the end of the macro step, or of the next one"]),
      text("A macro step that does not come to an end (10 000 micro steps) is a fault: divergence."),
    ],
  },
  {
    id: "derivation", title: "Why: derivations", group,
    blocks: [
      text("Every micro step is an inference by the rules of the semantics. The drawer Derivation shows them as trees: what holds stands below, why it holds above. Select a port to read in words why it fires or does not; at the actions and parameters of a state, Why? tells why one is executed or not, and what gives a value. Calls and events lists what was called and what came, each a way to its micro step."),
      text("The rules have the numbers of the thesis' equations; refinements (R1 to R26) are named where they decide."),
    ],
  },
  {
    id: "faults", title: "Faults", group,
    blocks: [
      text("A function that cannot be executed ends the run as faulted. The micro step in which that happens is taken back whole, the state stays for inspection, and the safe operations are called."),
      text("What each kind of fault means is in the list of errors."),
    ],
  },
  {
    id: "interrupted", title: "Interrupted runs", group,
    blocks: [
      text("A run whose server ends, whose disk fails, or that computes for too long is interrupted. All that it has done is in its journal, so it is rebuilt as it was. Calls that were open are answered with the error `unavailable`. Nothing goes on before somebody presses Resume."),
    ],
  },
  {
    id: "live", title: "Changing a running task", group,
    blocks: [
      text("A run follows the edits of its document if somebody has ticked Follow edits. Each edit without errors is taken over between two macro steps. One that removes what is active waits, and the page says for which state."),
      text("The bar above the drawing says which revision runs, which you edit, and what differs. A new port or action may move the robot."),
    ],
  },
  {
    id: "together", title: "Several people", group,
    blocks: [
      text("Everybody who has opened a document sees the edits of the others at once, and where they are. Undo takes back your own edits only. If two people change the same thing, the server decides which came first; what was refused is shown above the drawing."),
      heading("History"),
      text("Every edit makes a revision. History (Ctrl+Shift+H) lists them, shows what has changed, restores one, or branches from it."),
      heading("Coverage of tests"),
      text("`race test --coverage --json FILE > coverage.json` writes which states, ports and conditions the tests of a model come to. Coverage (Ctrl+Shift+Y) opens that file and marks in the drawing what no test comes to. Make a test, at the end of a run and in the list of runs, saves a run as a test file for `race test`."),
      heading("Proposals"),
      text("Who may not change documents, such as an agent of a language model, proposes a change: the top bar says how many wait. Accept one, and it is the next revision, which you can undo; or decline it, and say why. One whose document has changed since is outdated: it has to be proposed anew."),
    ],
  },
];
