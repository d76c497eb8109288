// The keys and mouse actions of the expert page: its handlers and its help use this table. As in RAFCON and Node-RED.
import type { Move } from "../past/moves";
import { allowed, primary, type Command } from "../run/controls";
import type { Core } from "../../generated/messages";
import { kStopKey } from "../stop/key";

/** Those of web/pro/debugger. */
export type DebugShortcut = "step_mode" | "into" | "over" | "out" | "until_here" | "breakpoint";
/** `cell_stop` is taken before all others, wherever the focus is (web/stop). */
export type Shortcut = DebugShortcut | "cell_stop" | "lead" | "pause" | "stop" | "micro" | "macro" | Move | "search" | "documents" | "runs" | "guide" | "fold_left" | "fold_right" | "fold_below" | "zoom_in" | "zoom_out" | "fit" | "follow" | "help" | "escape";

export interface ShortcutEntry {
  readonly shortcut: Shortcut;
  /** Each of these means it; Ctrl stands for the command key too. */
  readonly keys: readonly string[];
  readonly does: string;
}

export const shortcuts: readonly ShortcutEntry[] = [
  { shortcut: "cell_stop", keys: [kStopKey], does: "STOP: the robot brakes, all runs end, and nothing moves until the reset; also while you type, with any other key held" },
  { shortcut: "lead", keys: ["F5"], does: "Start the run, resume it, or run again; what starts a run asks first if that moves the robot" },
  { shortcut: "pause", keys: ["F7"], does: "Pause" },
  { shortcut: "micro", keys: ["F4"], does: "Micro step" },
  { shortcut: "macro", keys: ["Shift+F4"], does: "Macro step" },
  { shortcut: "step_mode", keys: ["F6"], does: "Step mode: pause, and go on by steps; again: resume" },
  { shortcut: "into", keys: ["F11"], does: "Step into the active state: until one in it is entered, or it is left" },
  { shortcut: "over", keys: ["F10"], does: "Step over the active state: until it is left" },
  { shortcut: "out", keys: ["Shift+F11"], does: "Step out of the active state: until the state around it is left" },
  { shortcut: "until_here", keys: ["Ctrl+F10"], does: "Run until the selected state is entered, or the selected port fires" },
  { shortcut: "breakpoint", keys: ["Ctrl+B"], does: "Set or remove a breakpoint at the selected state or port" },
  { shortcut: "stop", keys: ["F8"], does: "Stop: end the watched run" },
  { shortcut: "back", keys: ["F9"], does: "Back by a micro step: what is shown, not the run" },
  { shortcut: "forward", keys: ["Shift+F9"], does: "Forward again by a micro step" },
  { shortcut: "back_step", keys: ["Ctrl+F9"], does: "Back to the end of the macro step before" },
  { shortcut: "forward_step", keys: ["Ctrl+Shift+F9"], does: "Forward to the end of a macro step" },
  { shortcut: "zoom_in", keys: ["Ctrl++", "Ctrl+="], does: "Zoom in" },
  { shortcut: "zoom_out", keys: ["Ctrl+-"], does: "Zoom out" },
  { shortcut: "fit", keys: ["Ctrl+0", "Ctrl+Space"], does: "Show the whole drawing" },
  { shortcut: "follow", keys: ["Ctrl+Shift+Space"], does: "Follow the run: the drawing goes to what becomes active; until it is moved" },
  { shortcut: "search", keys: ["Ctrl+F"], does: "Search states, ports and code" },
  { shortcut: "documents", keys: ["Ctrl+O"], does: "Documents: new, open, upload, download, duplicate, delete" },
  { shortcut: "runs", keys: ["Ctrl+Shift+O"], does: "Runs: open, search, compare, download, delete" },
  { shortcut: "fold_left", keys: ["Ctrl+,"], does: "Fold the left panel away, or bring it back" },
  { shortcut: "fold_right", keys: ["Ctrl+."], does: "Fold the right panel away, or bring it back" },
  { shortcut: "fold_below", keys: ["Ctrl+J"], does: "Close the panel below a run, or open it again" },
  { shortcut: "guide", keys: ["F1"], does: "Help: tour, concepts, function language, error codes" },
  { shortcut: "help", keys: ["?"], does: "Show these keys" },
  { shortcut: "escape", keys: ["Esc"], does: "Close this panel, return to the present, or select nothing" },
];

/** What the mouse does, and the keys that one part of the page takes while it has the focus. */
export const gestures: readonly { readonly where: string; readonly list: readonly { readonly gesture: string; readonly does: string }[] }[] = [
  {
    where: "Model",
    list: [
      { gesture: "Wheel", does: "Zoom" },
      { gesture: "Drag, left or middle button", does: "Move the drawing" },
      { gesture: "Click a state or barrier", does: "Show its properties" },
      { gesture: "Click a port", does: "Why it fires, or does not" },
      { gesture: "Double click", does: "Go to the properties" },
      { gesture: "Ctrl and double click a composite state", does: "Enter it; the path above leads out again" },
      { gesture: "− or + in a composite state", does: "Collapse or expand it" },
      { gesture: "Right click", does: "Breakpoints, steps and forced outcomes" },
      { gesture: "Click the background", does: "Select nothing" },
    ],
  },
  {
    where: "Editor, mouse",
    list: [
      { gesture: "Drag from a port or barrier", does: "Lead it to a state, or to a new one" },
      { gesture: "Drag from Add or Library", does: "Put something new into the state under the pointer" },
      { gesture: "Ctrl or Shift and click", does: "Select besides, or no longer" },
      { gesture: "Shift and drag", does: "Select what is in the frame" },
      { gesture: "Double click", does: "The state editor; of anything else, the properties" },
      { gesture: "Ctrl and double click", does: "Enter the state" },
      { gesture: "Right click", does: "What can be done with it" },
      { gesture: "Esc while dragging", does: "Cancel the drag" },
    ],
  },
  {
    where: "Derivation",
    list: [
      { gesture: "Click a macro step", does: "Show its proof trees, and the model as it was then" },
      { gesture: "Click an inference", does: "Show it as the thesis prints it" },
      { gesture: "Double click, → and ←", does: "Unfold and fold its premises" },
      { gesture: "↑ and ↓", does: "Go from row to row" },
    ],
  },
  {
    where: "Documents",
    list: [
      { gesture: "Drop files on the page", does: "Store them as documents" },
      { gesture: "↑ and ↓, Enter", does: "Go through the list, and open a document" },
    ],
  },
  {
    where: "Runs",
    list: [
      { gesture: "Drop the file of a run on the page", does: "Store and show it" },
      { gesture: "← and → on the slider over a past moment", does: "Go from macro step to macro step" },
    ],
  },
  { where: "Search", list: [{ gesture: "Enter", does: "Go to the first result" }, { gesture: "↑ and ↓", does: "Go through the results" }] },
  {
    where: "Cell",
    list: [
      { gesture: "Drag", does: "Turn the view" },
      { gesture: "Drag, right button or two fingers", does: "Move the view" },
      { gesture: "Shift and drag, or drag after Pull", does: "Pull a link or a part" },
      { gesture: "Right click or long press on a part", does: "Take it away; Parts lists all of them" },
      { gesture: "Wheel", does: "Zoom" },
      { gesture: "Arrows, with Shift, + and −, Home", does: "Move, turn, zoom, and the view as at first" },
    ],
  },
  {
    where: "Borders between panels",
    list: [
      { gesture: "Drag", does: "Make a panel larger or smaller; Esc gives it up" },
      { gesture: "Arrows, Home and End", does: "The same, up to the bounds; with Shift in large steps" },
      { gesture: "Double click", does: "The usual size" },
      { gesture: "Enter", does: "Fold a side panel away, or bring it back" },
    ],
  },
];

/** The part of a keyboard event that identifies the keys. */
export type KeyPress = Pick<KeyboardEvent, "key" | "code" | "ctrlKey" | "metaKey" | "shiftKey" | "altKey">;

/** The press as `shortcuts` writes it. Shift counts with letters and named keys; of signs it is only the way to type them. Alt may type a sign with a letter: the letter counts. */
export function pressText({ key: typed, code, ctrlKey, metaKey, shiftKey, altKey }: KeyPress): string {
  const key = (altKey && !/^[a-z]$/i.test(typed) ? /^Key([A-Z])$/.exec(code)?.[1] : undefined) ?? typed;
  const name = code === "Space" ? "Space" : key === "Escape" ? "Esc" : key.length === 1 ? key.toUpperCase() : key;
  const shifts = shiftKey && (name.length > 1 || /\p{L}/u.test(name));
  return `${ctrlKey || metaKey ? "Ctrl+" : ""}${altKey ? "Alt+" : ""}${shifts ? "Shift+" : ""}${name}`;
}

/** The shortcut of a key press; while text is typed, a character is only that character. */
export function shortcutOf(press: KeyPress, typing: boolean): Shortcut | undefined {
  if (press.altKey) return undefined;
  const text = pressText(press);
  if (typing && text.length === 1) return undefined;
  return shortcuts.find((entry) => entry.keys.includes(text))?.shortcut;
}

/** The command that a shortcut gives this core, if it takes it. */
export function commandOf(shortcut: Shortcut, core: Core | undefined): Command | undefined {
  switch (shortcut) {
    case "lead":
      return primary(core);
    case "pause":
    case "stop":
    case "micro":
    case "macro":
      return allowed(core).has(shortcut) ? shortcut : undefined;
    default:
      return undefined;
  }
}

const kMoves: ReadonlySet<Shortcut> = new Set(["back", "forward", "back_step", "forward_step"] satisfies readonly Move[]);

/** Whether it moves what is shown through the past of the run. */
export const isMove = (shortcut: Shortcut): shortcut is Move => kMoves.has(shortcut);

/** The keys of a shortcut, for the name of its button. */
export function keysOf(shortcut: Shortcut): string {
  return shortcuts.find((entry) => entry.shortcut === shortcut)?.keys.join(" or ") ?? "";
}
