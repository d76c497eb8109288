// The services that a document names: key and type, those that are running first.
import { setField } from "../../../shared/edit/commands/setField";
import { entryOf, isObject, type JsonObject } from "../../../shared/json";
import { useSession } from "../../client";
import { perform } from "../editing";
import { ChoiceField } from "./ChoiceField";
import { named } from "./NameField";
import { Rows } from "./Rows";
import { TextField } from "./TextField";

export function ServiceRows({ fields }: { readonly fields: JsonObject }) {
  const running = useSession((s) => s.services);
  const declared = entryOf(fields, "services");
  const services = isObject(declared) ? Object.entries(declared) : [];
  const types = [...new Set(running.map(({ type }) => type))];
  const free = running.filter(({ key }) => !services.some(([each]) => each === key));
  const items = services.map(([key, type]) => ({ id: key, name: key, content: <ServiceRow service={key} type={typeof type === "string" ? type : ""} types={types} /> }));
  return (
    <>
      <Rows label="Services" one="service" items={items} onRemove={(key) => perform(setField("", "services", undefined, key))} />
      <div className="form-section">
        <ChoiceField
          label="Add"
          value=""
          place="/services"
          choices={[{ value: "", text: "a service…" }, ...free.map(({ key, type }) => ({ value: key, text: `${key} (${type})` })), { value: "service", text: "another one" }]}
          onChoose={(key) => perform(setField("", "services", free.find((service) => service.key === key)?.type ?? key, key))}
        />
      </div>
    </>
  );
}

function ServiceRow({ service, type, types }: { readonly service: string; readonly type: string; readonly types: readonly string[] }) {
  return (
    <div className="datum is-service">
      <TextField id="" field={`service:${service}`} label="Key" isBare className="row-name" now={service} change={named((name) => ({ compound: { kind: "rename_service", key: service, name } }))} />
      <span className="row-kind" aria-hidden="true">
        :
      </span>
      <TextField id="" field={`services:${service}`} label="Type" isBare className="row-value" now={type} choices={types} change={(text) => setField("", "services", text, service)} />
    </div>
  );
}
