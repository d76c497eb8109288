// What a service offers, for which nobody has written skills: folded, as it may be much.
import { useState } from "react";
import { searchOperations } from "../../shared/skills/serviceSkills";
import { texts } from "../texts";
import { operationSkills, type OfferedService } from "./offered";
import { SkillCard } from "./SkillCard";

const t = texts.library;

export function ServiceGroup({ service, query }: { readonly service: OfferedService; readonly query: string }) {
  const [isOpen, setOpen] = useState(false);
  const count = searchOperations(service, query).length;
  if (count === 0) return null;
  const title = t.service(service.key);
  return (
    <section aria-label={title}>
      <details onToggle={(event) => setOpen(event.currentTarget.open)}>
        <summary>
          <h3>{title}</h3>
          <small>{service.available ? t.operations(count) : t.away}</small>
        </summary>
        {isOpen && (
          <ul>
            {operationSkills(service, query).map((skill) => (
              <SkillCard key={skill.id} skill={skill} />
            ))}
          </ul>
        )}
      </details>
    </section>
  );
}
