// The icons of the run bar, the top bar, the 3D view and of ports, drawn on a 16 px grid.
const shapes = {
  play: "M4 2.5v11l9-5.5z",
  pause: "M4 3h3v10H4zM9 3h3v10H9z",
  stop: "M4.5 3.5h7a1 1 0 0 1 1 1v7a1 1 0 0 1-1 1h-7a1 1 0 0 1-1-1v-7a1 1 0 0 1 1-1z",
  micro: "M3 3v10l6-5zM11 3h2v10h-2z",
  macro: "M2 3v10l5-5zM7 3v10l5-5zM13 3h1.6v10H13z",
  back: "M13 4.6v6.8L7 8zM5 3H3v10h2z",
  forward: "M3 4.6L9 8l-6 3.4zM11 3h2v10h-2z",
  again: "M8 3a5 5 0 1 1-4.6 3l1.5.6A3.4 3.4 0 1 0 8 4.6V7L4.6 3.9 8 .8z",
  interrupted: "M8 1l7.2 13.2H.8zM7.2 5.6v4.6h1.6V5.6zM7.2 11.3v1.6h1.6v-1.6z",
  into: "M7.2 1h1.6v6h2.7L8 11 4.5 7h2.7zM8 12a1.6 1.6 0 1 1 0 3.2A1.6 1.6 0 1 1 8 12z",
  over: "M2 9.5A6 6 0 0 1 12.6 5.2L14 3.8V9H8.8l2.6-2.6A4.3 4.3 0 0 0 3.7 9.5zM8 12a1.6 1.6 0 1 1 0 3.2A1.6 1.6 0 1 1 8 12z",
  out: "M7.2 11h1.6V5h2.7L8 1 4.5 5h2.7zM8 12a1.6 1.6 0 1 1 0 3.2A1.6 1.6 0 1 1 8 12z",
  steps: "M1.5 13.5v-3h3.7v-3h3.7v-3h3.6V1.6h2V6.1h-3.6v3H7.2v3H3.5v1.4z",
  clock: "M8 .8a7.2 7.2 0 1 1 0 14.4A7.2 7.2 0 1 1 8 .8zm0 1.7a5.5 5.5 0 1 0 0 11 5.5 5.5 0 1 0 0-11zM7.2 4h1.6v3.6l2.5 1.5-.8 1.3-3.3-2z",
  half: "M8 1.2a6.8 6.8 0 1 1 0 13.6A6.8 6.8 0 1 1 8 1.2zm0 1.6v10.4a5.2 5.2 0 1 0 0-10.4z",
  sun: "M8 4.6a3.4 3.4 0 1 1 0 6.8 3.4 3.4 0 1 1 0-6.8zM7.2.8h1.6v2.4H7.2zM7.2 12.8h1.6v2.4H7.2zM.8 7.2h2.4v1.6H.8zM12.8 7.2h2.4v1.6h-2.4zM2.3 3.5l1.2-1.2 1.7 1.7L4 5.2zM10.8 12l1.2-1.2 1.7 1.7-1.2 1.2zM3.5 13.7l-1.2-1.2L4 10.8 5.2 12zM12 5.2L10.8 4l1.7-1.7 1.2 1.2z",
  moon: "M6.4 1.4A6.7 6.7 0 1 0 14.6 9.6 5.7 5.7 0 0 1 6.4 1.4z",
  hand: "M5 8.4V3.2a.9.9 0 0 1 1.8 0v3.6h.5V1.9a.9.9 0 0 1 1.8 0v4.9h.5V2.7a.9.9 0 0 1 1.8 0v4.6h.5V4.5a.9.9 0 0 1 1.8 0v5.9c0 2.9-1.8 4.8-4.5 4.8-2.1 0-3.3-.9-4.3-2.7L2.5 9.3c-.6-1.1.8-2 1.6-1.1z",
  parts: "M1.5 2h4.4v4.4H1.5zM3 3.5v1.4h1.4V3.5zM7.5 3.4h7v1.6h-7zM1.5 9.4h4.4v4.4H1.5zM3 10.9v1.4h1.4v-1.4zM7.5 10.8h7v1.6h-7z",
  home: "M8 1.4l6.8 6.2-1.1 1.2-.8-.7v6H9.4v-4H6.6v4H3.1v-6l-.8.7-1.1-1.2z",
  legend: "M8 .8a7.2 7.2 0 1 1 0 14.4A7.2 7.2 0 1 1 8 .8zm0 1.6a5.6 5.6 0 1 0 0 11.2A5.6 5.6 0 1 0 8 2.4zM7.1 7h1.8v4.8H7.1zM7.1 4.1h1.8v1.8H7.1z",
  cloud: "M3 2.2h2v2H3zM8 1.2h2v2H8zM12 4h2v2h-2zM6 5.4h2v2H6zM1.6 7h2v2h-2zM10 8.2h2v2h-2zM5 10h2v2H5zM13 11h2v2h-2zM8.6 12.6h2v2h-2zM2 12.4h2v2H2z",
} as const;

export type IconName = keyof typeof shapes;

/** Those with holes. */
const kHoles: ReadonlySet<IconName> = new Set(["interrupted", "clock", "half", "parts", "legend"]);

/** As an image, so that an icon is one element of the page. */
const imageOf = (name: IconName): string =>
  `url("data:image/svg+xml,${encodeURIComponent(`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 16 16"><path fill-rule="${kHoles.has(name) ? "evenodd" : "nonzero"}" d="${shapes[name]}"/></svg>`)}")`;
const images = Object.fromEntries(Object.keys(shapes).map((name) => [name, imageOf(name as IconName)])) as Readonly<Record<IconName, string>>;

/** In the colour of the text around. */
export const Icon = ({ name }: { readonly name: IconName }) => <svg className="icon" width="14" height="14" aria-hidden="true" style={{ maskImage: images[name], WebkitMaskImage: images[name] }} />;
