// The skills, by category, then what services offer: a press adds one behind what is selected, and it can be dragged to its place.
import { useEffect, useState } from "react";
import { searchOperations } from "../../shared/skills/serviceSkills";
import { kCategories, searchSkills, type Category } from "../../shared/skills/skill";
import { useSession } from "../client";
import { closeSheet } from "../closeSheet";
import { liesOver, useSheet } from "../sheet";
import { loadSkills } from "../skills";
import { whereToAdd } from "../step/actions";
import { useOffered, useServicesWithoutSkills } from "./offered";
import { ServiceGroup } from "./ServiceGroup";
import { SkillCard } from "./SkillCard";
import { usePlace } from "../place";
import { useApplication } from "../model";
import { texts } from "../texts";

const t = texts.library;
const titleOf = (category: Category | undefined): string => (category === undefined ? t.others : t.categories[category]);

export function SkillLibrary() {
  const skills = useOffered();
  const services = useServicesWithoutSkills();
  const documents = useSession((s) => s.documents);
  const [query, setQuery] = useState("");
  useEffect(() => void loadSkills(), [documents]);
  const sheet = useSheet();
  const [aside, setAside] = useState<HTMLElement | null>(null);
  useEffect(() => {
    if (sheet === "library" && aside !== null && liesOver(aside)) aside.focus();
  }, [sheet, aside]);
  const found = searchSkills(skills, query);
  const areServicesFound = services.some((service) => searchOperations(service, query).length > 0);
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
      {skills.length > 0 && found.length === 0 && !areServicesFound && <p className="quiet">{t.notFound}</p>}
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
      {services.map((service) => (
        <ServiceGroup key={service.key} service={service} query={query} />
      ))}
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
