// A time as a person says it.

const kSecond = 1000;
const kMinute = 60 * kSecond;
const kDay = 24 * 60 * kMinute;

/** `just now`, `10 min ago`, the time of today, or the day too. In ms since 1970; nothing of what is no time. */
export function timeText(at: number, now: number): string {
  if (Number.isNaN(at)) return "";
  const ago = now - at;
  if (ago >= 0 && ago < kMinute) return "just now";
  if (ago >= 0 && ago < 60 * kMinute) return `${Math.floor(ago / kMinute)} min ago`;
  const options: Intl.DateTimeFormatOptions = ago >= 0 && ago < kDay ? { timeStyle: "short" } : { dateStyle: "medium", timeStyle: "short" };
  return new Intl.DateTimeFormat(undefined, options).format(at);
}
