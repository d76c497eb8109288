// When something was said, as a reader of the page writes times.
const kSecond = 1000;
const kMinute = 60 * kSecond;
const kDay = 24 * 60 * kMinute;

/** `now`: [ms] since 1970. A time that is none gives an empty text. */
export function timeText(time: string, now: number): string {
  const at = Date.parse(time);
  if (Number.isNaN(at)) return "";
  const ago = now - at;
  if (ago >= 0 && ago < kMinute) return "just now";
  if (ago >= 0 && ago < 60 * kMinute) return `${Math.floor(ago / kMinute)} min ago`;
  const options: Intl.DateTimeFormatOptions = ago >= 0 && ago < kDay ? { timeStyle: "short" } : { dateStyle: "medium", timeStyle: "short" };
  return new Intl.DateTimeFormat(undefined, options).format(at);
}
