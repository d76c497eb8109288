// Changes the theme: system, light, dark, and again.
import { nextChoice, themeHint, themeText, type ThemeChoice } from "../../shared/theme/theme";
import { Icon, type IconName } from "../panels/Icon";
import { chooseTheme, useThemeChoice } from "./theme";

const icons: Readonly<Record<ThemeChoice, IconName>> = { system: "half", light: "sun", dark: "moon" };

export function ThemeButton() {
  const choice = useThemeChoice();
  return (
    <button type="button" className="help-button" aria-label={themeText(choice)} title={themeHint(choice)} onClick={() => chooseTheme(nextChoice(choice))}>
      <Icon name={icons[choice]} />
    </button>
  );
}
