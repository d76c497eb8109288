// The theme of a page: a person chooses light or dark, or leaves it to the system.
export type Theme = "light" | "dark";
export type ThemeChoice = Theme | "system";

export interface ThemeState {
  readonly choice: ThemeChoice;
  /** What the system prefers. */
  readonly system: Theme;
}

export type ThemeEvent = { readonly type: "chosen"; readonly choice: ThemeChoice } | { readonly type: "system"; readonly theme: Theme };

/** Every choice, each followed by the one that the button gives next. */
const kChoices: readonly ThemeChoice[] = ["system", "light", "dark"];

/** The choice that a text names; anything else leaves it to the system. */
export const choiceOf = (text: string | undefined): ThemeChoice => kChoices.find((choice) => choice === text) ?? "system";

export const nextChoice = (choice: ThemeChoice): ThemeChoice => kChoices[(kChoices.indexOf(choice) + 1) % kChoices.length] ?? "system";

export function applyTheme(state: ThemeState, event: ThemeEvent): ThemeState {
  return event.type === "chosen" ? { ...state, choice: event.choice } : { ...state, system: event.theme };
}

/** The theme that the page shows. */
export const shownTheme = ({ choice, system }: ThemeState): Theme => (choice === "system" ? system : choice);

const kNames: Readonly<Record<ThemeChoice, string>> = { system: "system", light: "light", dark: "dark" };

/** Name of the button that gives the next choice. */
export const themeText = (choice: ThemeChoice): string => `Theme: ${kNames[choice]}`;

/** What a press of that button does. */
export const themeHint = (choice: ThemeChoice): string => `${themeText(choice)}; press for ${kNames[nextChoice(choice)]}`;
