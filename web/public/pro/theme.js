// Runs before the first paint, so that the page never shows another theme than the chosen one. pro/theme/theme.ts keeps the choice.
try {
  document.documentElement.dataset.theme = localStorage.getItem("race.theme") ?? "system";
} catch {
  document.documentElement.dataset.theme = "system"; // Local storage is refused.
}
