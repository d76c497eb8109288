// Colours of tokens.css for what CSS does not draw.

/** The colour that this token has in the theme that is shown, as `rgb(…)`. */
export function tokenColour(token: `--${string}`): string {
  const probe = document.createElement("i");
  probe.style.color = `var(${token})`;
  document.body.append(probe);
  const { color } = getComputedStyle(probe);
  probe.remove();
  return color;
}
