// Colours of tokens.css for what CSS does not draw.

type Token = `--${string}`;

/** The colours that these tokens have in the theme that is shown, in their order, as `rgb(…)`. */
export function tokenColours(tokens: readonly Token[]): readonly string[] {
  const probe = document.createElement("i");
  document.body.append(probe);
  const style = getComputedStyle(probe);
  const colours = tokens.map((token) => {
    probe.style.color = `var(${token})`;
    return style.color;
  });
  probe.remove();
  return colours;
}

export const tokenColour = (token: Token): string => tokenColours([token])[0] ?? "";
