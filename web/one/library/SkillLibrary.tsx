// The skills, by category: a press adds one behind what is selected, and it can be dragged to its place.
import { useEffect, useState } from "react";
import { kCategories, searchSkills, type Category } from "../../shared/skills/skill";
import { useSession } from "../client";
import { closeSheet } from "../closeSheet";
import { useDrag } from "../line/drag";
import { Picture } from "../Picture";
import { liesOver, useSheet } from "../sheet";
import { loadSkills } from "../skills";
import { addSelectedSkill, whereToAdd } from "../step/actions";
import { useOffered, type Offered } from "./offered";
import { usePlace } from "../place";
import { useApplication } from "../model";
import { texts } from "../texts";

const t = texts.library;
const titleOf = (category: Category | undefined): string => (category === undefined ? t.others : t.categories[category]);

export function SkillLibrary() {
  const skills = useOffered();
  const documents = useSession((s) => s.documents);
  const [query, setQuery] = useState("");
  useEffect(() => void loadSkills(), [documents]);
  const sheet = useSheet();
  const [aside, setAside] = useState<HTMLElement | null>(null);
  useEffect(() => {
    if (sheet === "library" && aside !== null && liesOver(aside)) aside.focus();
  }, [sheet, aside]);
  const found = searchSkills(skills, query);
  const groups = [...kCategories, undefined].map((category) => ({ category, skills: found.filter((skill) => skill.category === category) }));
  return (
    <aside className="skills" aria-label={t.title} tabIndex={-1} ref={setAside}>
      <header>
        <h2>{t.title}</h2>
        <button type="button" className="plain sheet-close" aria-label={t.close} onClick={closeSheet}>
          ✕
        </button>
        <input type="search" aria-label={t.searchName} placeholder={t.search} value={query} onChange={(event) => setQuery(event.target.value)} />
        <Where />
      </header>
      {skills.length === 0 && <p className="quiet">{t.none}</p>}
      {skills.length > 0 && found.length === 0 && <p className="quiet">{t.notFound}</p>}
      {groups.map(
        (group) =>
          group.skills.length > 0 && (
            <section key={group.category ?? "other"} aria-label={titleOf(group.category)}>
              <h3>{titleOf(group.category)}</h3>
              <ul>
                {group.skills.map((skill) => (
                  <SkillCard key={`${skill.place.document ?? ""}/${skill.id}`} skill={skill} />
                ))}
              </ul>
            </section>
          ),
      )}
    </aside>
  );
}

/** Where a press adds a skill. */
function Where() {
  const application = useApplication();
  const [task, step] = [usePlace((place) => place.task), usePlace((place) => place.step)];
  if (application === undefined) return null;
  const where = whereToAdd(application, task, step);
  return <p className="where">{where === undefined ? (application.isEditable ? t.noTask : t.readOnly) : where.text}</p>;
}

function SkillCard({ skill }: { readonly skill: Offered }) {
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
