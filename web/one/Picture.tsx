// The picture of a skill, a task or a tool: lines in the colour of the text.
import { iconPath } from "../shared/skills/icons";
import type { Category } from "../shared/skills/skill";

interface Props {
  readonly name: string | undefined;
  readonly category?: Category | undefined;
}

export function Picture({ name, category }: Props) {
  return (
    <svg className="picture" viewBox="0 0 24 24" aria-hidden="true">
      <path d={iconPath(name, category)} />
    </svg>
  );
}
