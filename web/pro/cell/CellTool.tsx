// A tool of the 3D view: a sign, with its name where there is room for it.
import type { ButtonHTMLAttributes } from "react";
import { Icon, type IconName } from "../panels/Icon";

interface Props extends ButtonHTMLAttributes<HTMLButtonElement> {
  readonly name: string;
  readonly icon: IconName;
  /** What it does. */
  readonly hint: string;
}

export function CellTool({ name, icon, hint, ...rest }: Props) {
  return (
    <button type="button" className="cell-tool" aria-label={name} title={`${name}: ${hint}`} {...rest}>
      <Icon name={icon} />
      <span>{name}</span>
    </button>
  );
}
