// How a parameter of a skill is entered: from its domain, else its type, its unit, range and choices (api/skills.md).
import { readExact, type ExactJson } from "../edit/exact";
import { exactNumber } from "../timeline/numbers";
import { isObject, type JsonValue } from "../json";
import type { SkillChoice, SkillParameter } from "./skill";

/** A number is shown in `unit`, which is `factor` times that of the document. */
export interface NumberField {
  readonly kind: "slider" | "number";
  /** In the unit of the document; nothing: there is no bound. A slider has both. */
  readonly min: number | undefined;
  readonly max: number | undefined;
  readonly step: number;
  /** Whole numbers alone. */
  readonly whole: boolean;
  readonly factor: number;
  readonly unit: string;
  /** What everyday words there are for it. */
  readonly words: "force" | "speed" | undefined;
}

export type Field =
  | NumberField
  | { readonly kind: "choice"; readonly choices: readonly SkillChoice[] }
  /** The name of a taught pose. */
  | { readonly kind: "pose" }
  /** What the camera knows, one or several. */
  | { readonly kind: "label" }
  | { readonly kind: "labels" }
  /** Texts that nobody has listed. */
  | { readonly kind: "texts" }
  /** What an earlier step has found. */
  | { readonly kind: "found" }
  | { readonly kind: "colour" }
  | { readonly kind: "text" }
  | { readonly kind: "toggle" }
  /** To be read; RACE Pro changes it. */
  | { readonly kind: "other" };

/** What a domain means where the parameter says nothing more. */
const kRanges: Readonly<Record<string, { readonly min: number; readonly max?: number; readonly step: number }>> = {
  speed: { min: 0.05, max: 1, step: 0.05 }, force: { min: 5, max: 80, step: 1 }, distance: { min: 0, max: 1, step: 0.01 }, duration: { min: 0, step: 0.5 }, count: { min: 0, step: 1 },
};

/** Finer steps than so many are no slider, as they cannot be hit; counts are exact, so they are one only if they are few. */
const kMostSteps = 2000;
const kMostCounts = 20;

interface Shown {
  readonly factor: number;
  readonly unit: string;
}

function shownAs(domain: string | undefined, unit: string | undefined, max: number | undefined): Shown {
  if (domain === "speed") return { factor: 100, unit: "%" };
  const of = unit ?? (domain === "force" ? "N" : domain === "distance" ? "m" : domain === "duration" ? "s" : "");
  if (of === "m" && (max ?? 1) <= 1) return { factor: 100, unit: "cm" };
  if (of === "rad") return { factor: 180 / Math.PI, unit: "°" };
  return { factor: 1, unit: of };
}

function numberField({ type, unit, domain, min, max, step }: SkillParameter): NumberField {
  const range = domain === undefined ? undefined : kRanges[domain];
  const whole = type === "int" || (domain === "count" && type !== "number");
  const [low, high] = [min ?? range?.min, max ?? range?.max];
  const by = step ?? range?.step ?? (whole ? 1 : 0.01);
  const isSlider = low !== undefined && high !== undefined && (high - low) / by <= (whole ? kMostCounts : kMostSteps);
  const words = domain === "force" || domain === "speed" ? domain : undefined;
  return { kind: isSlider ? "slider" : "number", min: low, max: high, step: by, whole, ...shownAs(domain, unit, high), words };
}

const isTexts = (type: JsonValue | undefined): boolean => isObject(type) && type["list"] === "string";

const enumOf = (type: JsonValue | undefined): readonly SkillChoice[] => {
  const constants = isObject(type) ? type["enum"] : undefined;
  if (!Array.isArray(constants)) return [];
  return constants.map((value: JsonValue) => ({ value, title: typeof value === "string" ? value : JSON.stringify(value) }));
};

/** `value`: what it has now, for a parameter that says nothing of itself. */
export function fieldOf(parameter: SkillParameter, value?: JsonValue): Field {
  const { domain, type } = parameter;
  const choices = parameter.choices.length > 0 ? parameter.choices : enumOf(type);
  if (domain === "found") return { kind: "found" };
  if (choices.length > 0) return { kind: "choice", choices };
  if (domain === "pose" || domain === "label" || domain === "labels" || domain === "colour" || domain === "text") return { kind: domain };
  if (domain === "sound" || domain === "direction") return { kind: "text" };
  if (domain !== undefined && Object.hasOwn(kRanges, domain)) return numberField(parameter);
  if (type === "bool") return { kind: "toggle" };
  if (type === "int" || type === "number") return numberField(parameter);
  if (type === "string") return { kind: "text" };
  if (isTexts(type)) return { kind: "texts" };
  if (isObject(type) && type["optional"] !== undefined) return fieldOfOptional(parameter, type["optional"]);
  return type === undefined || type === "any" ? fieldOfValue(parameter, value) : { kind: "other" };
}

/** Yes, no and nothing are more than a toggle says. */
function fieldOfOptional(parameter: SkillParameter, type: JsonValue): Field {
  const field = fieldOf({ ...parameter, type });
  return field.kind === "toggle" ? { kind: "other" } : field;
}

function fieldOfValue(parameter: SkillParameter, value: JsonValue | undefined): Field {
  if (typeof value === "boolean") return { kind: "toggle" };
  if (typeof value === "string") return { kind: "text" };
  if (typeof value === "number") return numberField({ ...parameter, type: "number" });
  return { kind: "other" };
}

const kForces: readonly (readonly [below: number, word: string])[] = [[15, "gentle"], [35, "medium"], [Infinity, "firm"]];
const kSpeeds: readonly (readonly [below: number, word: string])[] = [[0.3, "slow"], [0.65, "medium"], [Infinity, "fast"]];

/** The everyday word for a force [N] or a share of the fastest. */
export const wordFor = (words: "force" | "speed", value: number): string => (words === "force" ? kForces : kSpeeds).find(([below]) => value < below)?.[1] ?? "";

const kDigits = 1e6;
const rounded = (value: number): number => Math.round(value * kDigits) / kDigits;

/** A number as it is shown, without its unit. */
export const shownNumber = ({ factor }: NumberField, value: number): string => String(rounded(value * factor));

/** `gentle 10 N`, `slow 25 %`, `5 cm`. */
export function numberText(field: NumberField, value: number): string {
  const number = `${shownNumber(field, value)}${field.unit === "" ? "" : field.unit === "°" ? "°" : ` ${field.unit}`}`;
  return field.words === undefined ? number : `${wordFor(field.words, value)} ${number}`;
}

export const limitsText = (field: NumberField): string => {
  const number = (value: number) => `${shownNumber(field, value)} ${field.unit}`.trim();
  if (field.min !== undefined && field.max !== undefined) return `${number(field.min)} to ${number(field.max)}`;
  return field.min !== undefined ? `at least ${number(field.min)}` : field.max !== undefined ? `at most ${number(field.max)}` : "a number";
};

/** A number that was typed, or moved to, as the document takes it; or what is wrong with it. */
export function readNumber(field: NumberField, text: string): { readonly value: ExactJson } | { readonly problem: string } {
  const typed = text.trim().replace(",", ".");
  if (!/^[-+]?(\d+\.?\d*|\.\d+)$/.test(typed)) return { problem: "a number, please" };
  // As it was typed, if the document has the same unit; else without the errors of the division.
  const value = field.factor === 1 ? Number(typed) : rounded(Number(typed) / field.factor);
  if (field.whole && !Number.isInteger(value)) return { problem: "a whole number, please" };
  if ((field.min !== undefined && value < field.min) || (field.max !== undefined && value > field.max)) return { problem: limitsText(field) };
  const digits = typed.replace(/^\+/, "").replace(/^(-?)\./, "$10.").replace(/\.$/, ".0").replace(/^(-?)0+(?=\d)/, "$1");
  return { value: field.factor !== 1 || field.whole || !digits.includes(".") ? exactNumber(value, field.whole) : readExact(digits) };
}

const listText = (items: readonly string[]): string => (items.length === 0 ? "all" : items.join(", "));

/** A value in words. */
export function valueText(parameter: SkillParameter, value: JsonValue): string {
  const field = fieldOf(parameter, value);
  switch (field.kind) {
    case "slider":
    case "number":
      return typeof value === "number" ? numberText(field, value) : JSON.stringify(value);
    case "choice":
      return field.choices.find((choice) => JSON.stringify(choice.value) === JSON.stringify(value))?.title ?? JSON.stringify(value);
    case "toggle":
      return value === true ? "yes" : "no";
    case "labels":
      return Array.isArray(value) ? listText(value.filter((item) => typeof item === "string")) : JSON.stringify(value);
    case "texts":
      return Array.isArray(value) ? value.filter((item) => typeof item === "string").join(", ") || "none" : JSON.stringify(value);
    case "found":
      return "";
    default:
      return typeof value === "string" ? value : shortJson(value);
  }
}

const kMostJson = 60;
const shortJson = (value: JsonValue): string => {
  const text = JSON.stringify(value);
  return text.length > kMostJson ? `${text.slice(0, kMostJson)}…` : text;
};

const kPoseName = /^[A-Za-z0-9_-]{1,32}$/;

/** Why a text is no name of a taught pose. */
export const reasonAgainstPose = (name: string): string | undefined => (kPoseName.test(name) ? undefined : "1 to 32 letters, digits, _ or -");

export const kMostText = 2000;
