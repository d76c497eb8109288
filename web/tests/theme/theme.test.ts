import { describe, expect, test } from "vitest";
import { applyTheme, choiceOf, nextChoice, shownTheme, themeHint, themeText, type ThemeState } from "../../shared/theme/theme";

const lightSystem: ThemeState = { choice: "system", system: "light" };

describe("theme", () => {
  test("follows the system until a person chooses", () => {
    expect(shownTheme(lightSystem)).toBe("light");
    const darkSystem = applyTheme(lightSystem, { type: "system", theme: "dark" });
    expect(shownTheme(darkSystem)).toBe("dark");
    const chosen = applyTheme(darkSystem, { type: "chosen", choice: "light" });
    expect(shownTheme(chosen)).toBe("light");
    expect(shownTheme(applyTheme(chosen, { type: "chosen", choice: "system" }))).toBe("dark");
  });

  test("a choice is not changed by the system", () => {
    const chosen = applyTheme(lightSystem, { type: "chosen", choice: "light" });
    expect(shownTheme(applyTheme(chosen, { type: "system", theme: "dark" }))).toBe("light");
  });

  test("pressing the button goes through all choices and returns", () => {
    expect(nextChoice("system")).toBe("light");
    expect(nextChoice("light")).toBe("dark");
    expect(nextChoice("dark")).toBe("system");
  });

  test("a text that names no choice leaves it to the system", () => {
    expect(choiceOf("dark")).toBe("dark");
    expect(choiceOf("sepia")).toBe("system");
    expect(choiceOf(undefined)).toBe("system");
  });

  test("the button is named by the choice and says what comes next", () => {
    expect(themeText("system")).toBe("Theme: system");
    expect(themeHint("dark")).toBe("Theme: dark; press for system");
  });
});
