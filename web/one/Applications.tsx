// The applications of the server, and a new one: where the page begins.
import { useEffect, useId, useState, type SubmitEvent } from "react";
import { namesOf } from "../shared/documents/listed";
import { freeDocumentName, newDocumentText } from "../shared/documents/names";
import { Bundles } from "./Bundles";
import { api, attempt, loadDocuments, useRefusal, useSession } from "./client";
import { author } from "./own";
import { go } from "./place";
import { texts } from "./texts";

const t = texts.applications;

export function Applications() {
  const documents = useSession((s) => s.documents);
  const isHere = useSession((s) => s.connection === "open");
  useEffect(() => {
    const reload = () => void loadDocuments();
    addEventListener("focus", reload);
    return () => removeEventListener("focus", reload);
  }, []);
  return (
    <main className="applications">
      <h1>{t.title}</h1>
      <section className="guide-offer" aria-label={texts.offer.title}>
        <h2>{texts.offer.title}</h2>
        <p>{texts.offer.about}</p>
        <button type="button" className="main" onClick={() => go({ guide: "cell" })}>
          {texts.offer.begin}
        </button>
      </section>
      <NewApplication />
      <h2>{t.list}</h2>
      <Bundles />
      {documents.length === 0 && <p className="quiet">{isHere ? t.none : t.asking}</p>}
      <ul className="application-list">
        {documents.map(({ name, doc, errors }) => (
          <li key={name}>
            <a
              href={`?edit=${encodeURIComponent(name)}`}
              onClick={(event) => {
                if (event.ctrlKey || event.metaKey || event.shiftKey) return;
                event.preventDefault();
                go({ edit: name, view: "build" });
              }}
            >
              <strong>{name}</strong>
              <span>{errors > 0 ? t.incomplete(errors) : (doc ?? "")}</span>
            </a>
          </li>
        ))}
      </ul>
    </main>
  );
}

/** What a document may be called, made of what was typed. */
const nameFrom = (typed: string): string => typed.normalize("NFD").replace(/[^A-Za-z0-9 _-]/g, "").trim().replace(/\s+/g, "-").slice(0, 60);

function NewApplication() {
  const id = useId();
  const documents = useSession((s) => s.documents);
  const refusal = useRefusal("store_document");
  const offline = useSession((s) => s.connection !== "open");
  const [typed, setTyped] = useState("");
  const make = (event: SubmitEvent) => {
    event.preventDefault();
    void attempt(async () => {
      const name = freeDocumentName(nameFrom(typed) === "" ? t.wish : nameFrom(typed), namesOf(documents));
      await api.putDocument(name, newDocumentText(name), { author: author() });
      await loadDocuments();
      go({ edit: name, view: "build" });
    });
  };
  return (
    <form className="new-application" onSubmit={make}>
      <label htmlFor={id}>{t.newOne}</label>
      <div>
        <input id={id} placeholder={t.hint} maxLength={60} value={typed} onChange={(event) => setTyped(event.target.value)} />
        <button type="submit" className="main" disabled={refusal !== undefined || offline} title={refusal}>
          {t.begin}
        </button>
      </div>
      {refusal !== undefined && <p className="quiet">{t.refused(refusal)}</p>}
    </form>
  );
}
