/** Default album name: the common folder of all photos, or the days on which they were taken. */

/**
 * Origin of a photo. `folders`: from the outermost, empty without a folder. `taken`: capture time, `YYYY:MM:DD
 * HH:MM:SS`. `modified`: time of its file in ms, if the file is available; a function, because Chromium asks another
 * process for it, and waits. `sample`: whether it is a sample of the app.
 */
export type Origin = {
  folders: readonly string[];
  taken: string | null;
  modified: () => number | null;
  sample?: boolean;
};

/** Folder names of cameras, systems and programs, which do not describe the content. */
const EMPTY_NAMES =
  /^(dcim|\d{3}[a-z0-9_]{5}|camera( roll)?|downloads?|desktop|documents?|pictures?|photos?|images?|fotos?|bilder|imágenes|imagens|descargas|téléchargements|ダウンロード|画像|写真|new folder.*|neuer ordner.*|tmp|temp)$/i;

const DAY = 86_400_000;
/** A longer album has no single event, so its days do not make a title. */
const MAX_EVENT = 31 * DAY;
/** Earliest plausible capture date. Earlier dates mean that the clock was not set. */
const FIRST_DAY = Date.UTC(1990, 0, 2);

/**
 * @param how `now` in ms; `dates` formats a range of days, in ms of UTC, in the language of the app
 * @returns empty without information
 */
export function albumName(
  origins: readonly Origin[],
  { samples, dates, now }: { samples: string; dates: (from: number, to: number) => string; now: number },
): string {
  if (origins.length === 0) return '';
  if (origins.every(({ sample }) => sample)) return samples;
  return folderName(origins) || daysName(origins, dates, now);
}

/**
 * The title of a page. File times are ignored, because copying changes them.
 * @returns empty if the photos have no common folder, and if most have no date or they are not from one event
 */
export function albumTitle(origins: readonly Origin[], how: Parameters<typeof albumName>[1]): string {
  const days = origins.map((origin) => dayTaken(origin, how.now));
  const dated = isOneEvent(days) ? origins : origins.map((origin) => ({ ...origin, taken: null }));
  return albumName(
    dated.map((origin) => ({ ...origin, modified: () => null })),
    how,
  );
}

/** @param times in ms, `null` if unknown @returns whether at least two thirds are known, and all within a month */
export function isOneEvent(times: readonly (number | null)[]): boolean {
  const known = times.filter((time) => time !== null);
  return known.length * 3 >= times.length * 2 && Math.max(...known) - Math.min(...known) <= MAX_EVENT;
}

/**
 * Whether a name consists of dates only, in the language of `dates`. Such a name is probably automatic: a project does not
 * store who named it.
 */
export function isDates(name: string, dates: (from: number, to: number) => string): boolean {
  if (!/\d{4}/.test(name)) return false;
  const words = (text: string) => text.toLowerCase().match(/\p{L}+/gu) ?? [];
  const months = Array.from({ length: 12 }, (_, month) => Date.UTC(2000, month, 10));
  const ranges = months.flatMap((day) => [dates(day, day), dates(day, day + DAY), dates(day, day + 99 * DAY)]);
  const known = new Set(ranges.flatMap(words));
  return words(name).every((word) => known.has(word));
}

/** When a photo was taken, in local milliseconds as if they were UTC, and the folder that names the place. */
export function momentOf({ folders, taken }: Origin, now: number): { at: number | null; place: string } {
  const [, year, month, day, hour, minute] = /^(\d{4}):(\d\d):(\d\d) (\d\d):(\d\d)/.exec(taken ?? '') ?? [];
  const at = year ? real(Date.UTC(+year, +month - 1, +day, +hour, +minute), now) : null;
  const folder = folders.at(-1)?.trim() ?? '';
  return { at, place: EMPTY_NAMES.test(folder) ? '' : folder };
}

function folderName(origins: readonly Origin[]): string {
  const [first, ...rest] = origins.map(({ folders }) => folders);
  const apart = first.findIndex((folder, i) => rest.some((folders) => folders[i] !== folder));
  const common = apart < 0 ? first : first.slice(0, apart);
  return common.findLast((folder) => folder.trim() !== '' && !EMPTY_NAMES.test(folder.trim()))?.trim() ?? '';
}

function daysName(origins: readonly Origin[], dates: (from: number, to: number) => string, now: number): string {
  const taken = origins.flatMap((origin) => dayTaken(origin, now) ?? []);
  // File times are often the times of copies. They count only without capture times.
  const days =
    taken.length * 2 >= origins.length
      ? taken
      : origins.flatMap((origin) => dayTaken(origin, now) ?? dayOf(origin.modified(), now) ?? []);
  if (days.length === 0) return '';
  return dates(Math.min(...days), Math.max(...days));
}

function dayTaken({ taken }: Origin, now: number): number | null {
  const [, year, month, day] = /^(\d{4}):(\d\d):(\d\d)/.exec(taken ?? '') ?? [];
  return year ? real(Date.UTC(Number(year), Number(month) - 1, Number(day)), now) : null;
}

/** Returns the day of a moment in the user's time zone. */
function dayOf(time: number | null, now: number): number | null {
  if (time === null) return null;
  const at = new Date(time);
  return real(Date.UTC(at.getFullYear(), at.getMonth(), at.getDate()), now);
}

function real(day: number, now: number): number | null {
  return day >= FIRST_DAY && day <= now + 2 * DAY ? day : null;
}
