// The icons of the run bar and of ports, drawn on a 16 px grid.
const shapes = {
  play: <path d="M4 2.5v11l9-5.5z" />,
  pause: <path d="M4 3h3v10H4zM9 3h3v10H9z" />,
  stop: <rect x="3.5" y="3.5" width="9" height="9" rx="1" />,
  micro: <path d="M3 3v10l6-5zM11 3h2v10h-2z" />,
  macro: <path d="M2 3v10l5-5zM7 3v10l5-5zM13 3h1.6v10H13z" />,
  again: <path d="M8 3a5 5 0 1 1-4.6 3l1.5.6A3.4 3.4 0 1 0 8 4.6V7L4.6 3.9 8 .8z" />,
  interrupted: <path fillRule="evenodd" d="M8 1l7.2 13.2H.8zM7.2 5.6v4.6h1.6V5.6zM7.2 11.3v1.6h1.6v-1.6z" />,
  clock: <path fillRule="evenodd" d="M8 .8a7.2 7.2 0 1 1 0 14.4A7.2 7.2 0 1 1 8 .8zm0 1.7a5.5 5.5 0 1 0 0 11 5.5 5.5 0 1 0 0-11zM7.2 4h1.6v3.6l2.5 1.5-.8 1.3-3.3-2z" />,
} as const;

export type IconName = keyof typeof shapes;

export function Icon({ name }: { readonly name: IconName }) {
  return (
    <svg viewBox="0 0 16 16" width="14" height="14" fill="currentColor" aria-hidden="true">
      {shapes[name]}
    </svg>
  );
}
