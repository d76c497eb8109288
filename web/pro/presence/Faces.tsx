// Who is at the document: a face for each, the own one first. A click on another's leads to where they are; in place of the own one the name is asked.
import { useState, type KeyboardEvent } from "react";
import { initialsOf, kMaxName, nameFrom } from "../../shared/presence/names";
import { selfOf } from "../../shared/presence/people";
import { useLogin } from "../client";
import { goToPerson } from "./goTo";
import { useOthers, type Other } from "./others";
import { chooseName, useOwnName } from "./ownName";
import { usePeople } from "./presence";

/** So many faces have room; the others are counted. */
const kFaces = 8;

export function Faces() {
  const others = useOthers();
  const full = usePeople((people) => people.full);
  const more = others.slice(kFaces);
  return (
    <div className="faces" role="group" aria-label="People at this document">
      <OwnFace />
      {others.slice(0, kFaces).map((other) => (
        <Face key={other.person.id} {...other} />
      ))}
      {more.length > 0 && (
        <span className="faces-more" title={more.map(({ name }) => name).join(", ")}>
          +{more.length}
        </span>
      )}
      {full && (
        <span className="faces-full" role="status" title="64 people are at this document already">
          others do not see you
        </span>
      )}
    </div>
  );
}

function Face({ person, name }: Other) {
  return (
    <button type="button" className={`face person-${person.colour}`} data-person={person.id} aria-label={`Go to ${name}`} title={`${name}: go to where they are`} onClick={() => goToPerson(person)}>
      {initialsOf(person.name)}
    </button>
  );
}

function OwnFace() {
  const { name, chosen } = useOwnName();
  const colour = usePeople((people) => selfOf(people)?.colour);
  const [asked, ask] = useState(false);
  const account = useLogin((login) => login.me?.name);
  if (account !== undefined)
    return (
      <span className={`face is-own${colour === undefined ? "" : ` person-${colour}`}`} role="img" aria-label={`You are ${account}`} title={`You are ${account}`}>
        {initialsOf(account)}
      </span>
    );
  if (asked || !chosen) return <OwnName name={name} focused={asked} onDone={() => ask(false)} />;
  return (
    <button type="button" className={`face is-own${colour === undefined ? "" : ` person-${colour}`}`} aria-label={`You are ${name}: change your name`} title={`You are ${name}. Click to change your name`} onClick={() => ask(true)}>
      {initialsOf(name)}
    </button>
  );
}

interface OwnNameProps {
  readonly name: string;
  /** The person has asked for the field; else it waits, and nobody is disturbed. */
  readonly focused: boolean;
  readonly onDone: () => void;
}

function OwnName({ name, focused, onDone }: OwnNameProps) {
  const [typed, type] = useState(name);
  const done = (chosen: string) => {
    chooseName(chosen);
    onDone();
  };
  const keep = () => done(nameFrom(typed) ?? name);
  const press = (event: KeyboardEvent) => {
    event.stopPropagation();
    if (event.key === "Escape") done(name);
    else if (event.key === "Enter") keep();
  };
  return (
    <input
      className="own-name"
      aria-label="Your name, as others see it"
      title="Your name, as others see it. Enter keeps it"
      maxLength={kMaxName}
      value={typed}
      autoFocus={focused}
      onFocus={({ target }) => target.select()}
      onChange={({ target }) => type(target.value)}
      onKeyDown={press}
      onBlur={keep}
    />
  );
}
