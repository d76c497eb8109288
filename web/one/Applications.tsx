// The applications of the server, and a new one: where the page begins.
import { useEffect, useId, useState, type SubmitEvent } from "react";
import { namesOf } from "../shared/documents/listed";
import { freeDocumentName, newDocumentText } from "../shared/documents/names";
import { counted } from "../shared/counted";
import { api, attempt, loadDocuments, useRefusal, useSession } from "./client";
import { author } from "./own";
import { go } from "./place";
import { texts } from "./texts";

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
      <h1>What shall the robot do?</h1>
      <section className="guide-offer" aria-label={texts.offer.title}>
        <h2>{texts.offer.title}</h2>
        <p>{texts.offer.about}</p>
        <button type="button" className="main" onClick={() => go({ guide: "cell" })}>
          {texts.offer.begin}
        </button>
      </section>
      <NewApplication />
      <h2>Your applications</h2>
      {documents.length === 0 && <p className="quiet">{isHere ? "There are none yet: make the first one above." : "Asking the server…"}</p>}
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
              <span>{errors > 0 ? `Not complete yet: ${counted(errors, "error")}` : (doc ?? "")}</span>
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
      const name = freeDocumentName(nameFrom(typed) === "" ? "application" : nameFrom(typed), namesOf(documents));
      await api.putDocument(name, newDocumentText(name), { author: author() });
      await loadDocuments();
      go({ edit: name, view: "build" });
    });
  };
  return (
    <form className="new-application" onSubmit={make}>
      <label htmlFor={id}>A new application</label>
      <div>
        <input id={id} placeholder="Name, such as: sort parts" maxLength={60} value={typed} onChange={(event) => setTyped(event.target.value)} />
        <button type="submit" className="main" disabled={refusal !== undefined || offline} title={refusal}>
          Begin
        </button>
      </div>
      {refusal !== undefined && <p className="quiet">Not here: {refusal}.</p>}
    </form>
  );
}
