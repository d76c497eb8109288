// A skill that is offered.
import { useDrag } from "../line/drag";
import { Picture } from "../Picture";
import { addSelectedSkill } from "../step/actions";
import type { Offered } from "./offered";

export function SkillCard({ skill }: { readonly skill: Offered }) {
  const drag = useDrag({ kind: "skill", title: skill.title, place: skill.place });
  const isHere = skill.missing === undefined;
  return (
    <li className={`skill is-${skill.category ?? "other"}`}>
      <button
        type="button"
        aria-disabled={!isHere}
        title={skill.doc}
        data-skill={skill.name}
        onPointerDown={isHere ? drag.fromCard : undefined}
        onClick={(click) => isHere && drag.isClick(click) && addSelectedSkill(skill.place)}
      >
        <Picture name={skill.icon} category={skill.category} />
        <span>
          <strong>{skill.title}</strong>
          {skill.missing !== undefined && <small>{skill.missing}</small>}
        </span>
      </button>
      {isHere && <i className="grip" aria-hidden="true" onPointerDown={drag.fromGrip} />}
    </li>
  );
}
