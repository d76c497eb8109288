// Nothing is selected: the document itself.
import { setField } from "../../../shared/edit/commands/setField";
import { entryOf, isObject } from "../../../shared/json";
import { useEditing } from "../editing";
import { FieldErrors } from "./FieldErrors";
import { ServiceRows } from "./ServiceRows";
import { TextField } from "./TextField";
import { counted } from "../../../shared/counted";

const textOf = (value: unknown): string => (typeof value === "string" ? value : "");

export function DocumentForm() {
  const fields = useEditing(({ session }) => session?.view?.fields);
  const count = useEditing(({ session }) => session?.view?.elements.size ?? 0);
  if (fields === undefined) return null;
  const about = entryOf(fields, "meta");
  return (
    <div className="form">
      <header className="form-head">
        <small>Document, {counted(count, "element")}</small>
        <TextField id="" field="name" label="Name" isBare className="form-title" placeholder="name" now={textOf(entryOf(fields, "name"))} change={(name) => setField("", "name", name === "" ? undefined : name)} />
        <FieldErrors id="" field="" />
      </header>
      <TextField
        id=""
        field="meta:description"
        label="Description"
        kind="lines"
        isBare
        placeholder="What the task is for"
        now={textOf(isObject(about) ? entryOf(about, "description") : undefined)}
        change={(text) => setField("", "meta", text === "" ? undefined : text, "description")}
      />
      <ServiceRows fields={fields} />
    </div>
  );
}
