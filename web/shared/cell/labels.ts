// Positions of labels that would overlap in a small view.

export interface Label {
  /** Its preferred position: left edge and top [px]. */
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

const kGap = 2;

const clamp = (value: number, most: number): number => Math.max(0, Math.min(value, most));
const overlap = (a: Label, b: Label): boolean => a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;

/** Each label inside of the view if it can be, below those above it that it would cover, or above them where the view ends. In the order given. */
export function apart(labels: readonly Label[], view: { readonly width: number; readonly height: number }): readonly Label[] {
  const inside = labels.map((label) => ({ ...label, x: clamp(label.x, view.width - label.width), y: clamp(label.y, view.height - label.height) }));
  const placed = new Map<Label, Label>();
  for (const label of [...inside].sort((a, b) => a.y - b.y)) {
    const free = (y: number) => ![...placed.values()].some((other) => overlap({ ...label, y }, other));
    const edges = [...placed.values()].flatMap((other) => [other.y + other.height + kGap, other.y - label.height - kGap]);
    const places = edges.filter((y) => y >= 0 && y <= view.height - label.height && free(y)).sort((a, b) => Math.abs(a - label.y) - Math.abs(b - label.y));
    placed.set(label, free(label.y) ? label : { ...label, y: places[0] ?? label.y });
  }
  return inside.map((label) => placed.get(label) ?? label);
}
