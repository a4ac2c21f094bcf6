/** Formats that follow the locale: numbers, sizes, times, lists. */

/** Maximum decimal places of a number with full precision. */
const MOST_DIGITS = 6;
/** Maximum number of days of a range that shows both dates. */
const MOST_DAYS = 62;

/** @param locale such as `de` or `es-MX` */
export function numbersIn(locale: string) {
  const formats: Map<string, Intl.NumberFormat> = new Map();
  let lists: Intl.ListFormat | undefined;

  /** Formats are cached, because creating one takes longer than using it a thousand times. */
  function format(value: number, digits: number | undefined, how: Intl.NumberFormatOptions = {}) {
    const name = `${digits} ${how.style} ${how.unit}`;
    const known =
      formats.get(name) ??
      new Intl.NumberFormat(locale, {
        ...how,
        minimumFractionDigits: digits,
        maximumFractionDigits: digits ?? MOST_DIGITS,
      });
    formats.set(name, known);
    return known.format(value);
  }

  /** @param digits decimal places; all by default */
  const decimal = (value: number, digits?: number) => format(value, digits);

  const unit = (value: number, name: string, digits: number) => format(value, digits, { style: 'unit', unit: name });

  /** @returns minutes and seconds, and hours if necessary: `1:02:03.4` */
  function clock(seconds: number): string {
    const tenths = Math.round(seconds * 10);
    const [hours, minutes, rest] = [Math.floor(tenths / 36_000), Math.floor(tenths / 600) % 60, (tenths % 600) / 10];
    const two = (value: number, text: string) => (value < 10 ? `0${text}` : text);
    return `${hours ? `${hours}:${two(minutes, `${minutes}`)}` : minutes}:${two(rest, decimal(rest, 1))}`;
  }

  /**
   * @param from a day, in milliseconds of UTC
   * @param to a day not before it
   * @returns the range in the usual form: `3–5 June 2026`. Longer ranges show only months, or only years
   */
  function dates(from: number, to: number): string {
    const days = (to - from) / 86_400_000;
    const year = 'numeric';
    const parts: Intl.DateTimeFormatOptions =
      days <= MOST_DAYS ? { day: 'numeric', month: 'long', year } : days <= 366 ? { month: 'long', year } : { year };
    const format = new Intl.DateTimeFormat(locale, { ...parts, timeZone: 'UTC' });
    const ends = [format.format(from), format.format(to)];
    // If a language formats ranges only with digits, both dates in words are easier to read as a name.
    const range = typeof format.formatRange === 'function' ? format.formatRange(from, to) : '/';
    // Some languages use special spaces, which are replaced.
    return (range.includes('/') ? [...new Set(ends)].join(' – ') : range).replaceAll(/\s+/gu, ' ');
  }

  /** @param at in milliseconds of UTC */
  const written = (at: number, parts: Intl.DateTimeFormatOptions) =>
    new Intl.DateTimeFormat(locale, { ...parts, timeZone: 'UTC' }).format(at).replaceAll(/\s+/gu, ' ');

  return {
    decimal,
    dates,
    /** @returns a day such as `Saturday, June 14` */
    dayOf: (at: number) => written(at, { weekday: 'long', day: 'numeric', month: 'long' }),
    /** @returns a day such as `June 14` */
    shortDayOf: (at: number) => written(at, { day: 'numeric', month: 'long' }),
    /** @returns a time of day such as `6:30 PM` */
    timeOf: (at: number) => written(at, { hour: 'numeric', minute: '2-digit' }),
    clock,
    /** @param part of 1 */
    percent: (part: number, digits = 0) => format(part, digits, { style: 'percent' }),
    fileSize: (bytes: number) =>
      bytes < 1e6 ? unit(Math.max(1, bytes / 1e3), 'kilobyte', 0) : unit(bytes / 1e6, 'megabyte', bytes < 1e7 ? 1 : 0),
    /** @param time in milliseconds since 1970 */
    moment: (time: number) => new Date(time).toLocaleString(locale, { dateStyle: 'medium', timeStyle: 'short' }),
    listed: (things: readonly string[]) =>
      things.length < 2 ? things.join('') : (lists ??= new Intl.ListFormat(locale)).format(things),
  };
}
