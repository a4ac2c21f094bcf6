/**
 * Times of a video start at its first frame. In the file that frame may have any time: transport streams begin with a
 * random one, and an edit list can start the frames after the sound.
 */

import type { Wish } from './video.ts';

export type FilmClock = ReturnType<typeof createFilmClock>;

/** time of the first frame, in seconds of the file */
export function createFilmClock(first: number) {
  const inFile = (time: number) => time + first;
  const inFilm = (time: number) => Math.max(0, time - first);

  return { inFilm, wishInFile };

  /** The same wish in seconds of the file. */
  function wishInFile<Asked extends Wish>({ start, end, times, moments, ...wish }: Asked) {
    return {
      ...wish,
      start: start === undefined ? undefined : inFile(start),
      end: end === undefined ? undefined : inFile(end),
      times: times?.map(inFile),
      moments: moments?.map(inFile),
    };
  }
}
