import { describe, expect, it } from "vitest";
import type { Core } from "../../generated/messages";
import { commandOf, keysOf, pressText, shortcutOf, shortcuts, type KeyPress } from "../../shared/session/shortcuts";

const core: Core = { id: "1", document: "pick", revision: 3, status: "running", paused: false, stepping: false, step: 1, micro: 0, waiting: 0, arguments: {}, breakpoints: [], live: false, model: 0 };
const press = (key: string, held: Partial<KeyPress> = {}): KeyPress => ({ key, code: "", ctrlKey: false, metaKey: false, shiftKey: false, altKey: false, ...held });
const ctrl = { ctrlKey: true };

describe("shortcutOf", () => {
  it.each<[string, KeyPress, string | undefined]>([
    ["F5", press("F5"), "lead"],
    ["F4", press("F4"), "micro"],
    ["Shift+F4", press("F4", { shiftKey: true }), "macro"],
    ["Shift+F5", press("F5", { shiftKey: true }), undefined],
    ["Ctrl+F5", press("F5", ctrl), undefined],
    ["? of a keyboard that needs Shift for it", press("?", { shiftKey: true }), "help"],
    ["Ctrl and + with Shift", press("+", { ctrlKey: true, shiftKey: true }), "zoom_in"],
    ["Ctrl and + of the keypad", press("+", ctrl), "zoom_in"],
    ["Ctrl and =, where + needs Shift", press("=", ctrl), "zoom_in"],
    ["Ctrl and -", press("-", ctrl), "zoom_out"],
    ["Ctrl and 0", press("0", ctrl), "fit"],
    ["Cmd and 0", press("0", { metaKey: true }), "fit"],
    ["Ctrl and Space", press(" ", { ctrlKey: true, code: "Space" }), "fit"],
    ["Ctrl+F", press("f", ctrl), "search"],
    ["Ctrl+Shift+F", press("F", { ctrlKey: true, shiftKey: true }), undefined],
    ["Escape", press("Escape"), "escape"],
    ["a plain letter", press("f"), undefined],
    ["+ alone", press("+"), undefined],
    ["what AltGr types", press("?", { ctrlKey: true, altKey: true }), undefined],
  ])("reads %s", (_, key, shortcut) => expect(shortcutOf(key, false)).toBe(shortcut));

  it("ignores characters while the user types, and keeps keys that type nothing", () => {
    expect(shortcutOf(press("?", { shiftKey: true }), true)).toBeUndefined();
    expect(shortcutOf(press("Escape"), true)).toBe("escape");
    expect(shortcutOf(press("0", ctrl), true)).toBe("fit");
    expect(shortcutOf(press("F8"), true)).toBe("stop");
  });
});

describe("pressText", () => {
  it("takes the letter of a key that types a sign with Alt, where that is no letter", () => {
    const alt = { ctrlKey: true, altKey: true };
    expect(pressText(press("l", { ...alt, code: "KeyL" }))).toBe("Ctrl+Alt+L");
    expect(pressText(press("ł", { ...alt, code: "KeyL" }))).toBe("Ctrl+Alt+L");
    expect(pressText(press("q", { altKey: true, code: "KeyA" }))).toBe("Alt+Q");
    expect(pressText(press("ł", { code: "KeyL" }))).toBe("Ł");
  });
});

describe("shortcuts", () => {
  it("mean one thing each", () => {
    const keys = shortcuts.flatMap((entry) => entry.keys);
    expect(new Set(keys).size).toBe(keys.length);
    expect(new Set(shortcuts.map((entry) => entry.shortcut)).size).toBe(shortcuts.length);
  });
  it("name their keys for buttons", () => {
    expect(keysOf("macro")).toBe("Shift+F4");
    expect(keysOf("fit")).toBe("Ctrl+0 or Ctrl+Space");
  });
});

describe("commandOf", () => {
  it("gives F5 the meaning of the first button", () => {
    expect(commandOf("lead", { ...core, status: "ready" })).toBe("start");
    expect(commandOf("lead", { ...core, paused: true })).toBe("resume");
    expect(commandOf("lead", { ...core, status: "ended" })).toBe("again");
    expect(commandOf("lead", core)).toBeUndefined();
  });
  it("commands only what the core takes", () => {
    expect(commandOf("micro", { ...core, paused: true })).toBe("micro");
    expect(commandOf("macro", { ...core, paused: true })).toBe("macro");
    expect(commandOf("micro", core)).toBeUndefined();
    expect(commandOf("stop", core)).toBe("stop");
    expect(commandOf("pause", core)).toBe("pause");
    expect(commandOf("stop", undefined)).toBeUndefined();
  });
  it("makes no command of shortcuts of the page", () => {
    for (const shortcut of ["search", "zoom_in", "zoom_out", "fit", "help", "escape"] as const) expect(commandOf(shortcut, core)).toBeUndefined();
  });
});
