// The theme of this page: a store of the choice and of the system's preference, shown by `data-theme` and kept in local storage.
import { applyTheme, choiceOf, shownTheme, type Theme, type ThemeChoice, type ThemeEvent, type ThemeState } from "../../shared/theme/theme";
import { createStore, useSelected } from "../../page/store";
import { tokenColour } from "./tokenColour";

/** public/pro/theme.js reads it too. */
const kKey = "race.theme";

const page = document.documentElement;
const darkSystem = matchMedia("(prefers-color-scheme: dark)");
const systemTheme = (): Theme => (darkSystem.matches ? "dark" : "light");

const store = createStore<ThemeState, ThemeEvent>({ choice: choiceOf(page.dataset["theme"]), system: systemTheme() }, applyTheme);

export const useThemeChoice = (): ThemeChoice => useSelected(store, (state) => state.choice);

/** Calls `listener` when other colours are shown; the result ends that. */
export function listenToTheme(listener: () => void): () => void {
  let before = shownTheme(store.get());
  return store.listen(() => {
    const now = shownTheme(store.get());
    if (now === before) return;
    before = now;
    listener();
  });
}

/** Shows this theme from now on, on this page and on those opened later. */
export function chooseTheme(choice: ThemeChoice): void {
  page.dataset["theme"] = choice;
  store.dispatch({ type: "chosen", choice });
  try {
    localStorage.setItem(kKey, choice);
  } catch {
    // Local storage is refused: the choice holds for this page.
  }
}

/** The browser's own frame takes the colour of the top bar. */
function colourFrame(): void {
  document.querySelector("meta[name=theme-color]")?.setAttribute("content", tokenColour("--panel"));
}

colourFrame();
listenToTheme(colourFrame);
darkSystem.addEventListener("change", () => store.dispatch({ type: "system", theme: systemTheme() }));
