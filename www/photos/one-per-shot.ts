/** Chooses frames of a video so that a page does not repeat its shots. */

import type { Album } from '../document/album.ts';
import type { PhotoMeta } from '../engine/types.ts';

/** @returns the shot of a frame, as text; null for a photo, and for a frame of an unknown shot */
export function shotOf(album: Album, id: string): string | null {
  const { video, shot } = album.get(id) ?? {};
  return video === undefined || shot === undefined ? null : `${video} ${shot}`;
}

/**
 * Removes frames whose shot has a better one: with a face, or sharper.
 * @param least number of photos to keep. If there are fewer shots, each shot keeps its best frames
 */
export function onePerShot(photos: readonly PhotoMeta[], album: Album, least: number): PhotoMeta[] {
  const rank = ({ subjects, sharpness }: PhotoMeta) =>
    Number(subjects.some(({ label }) => label === 'face')) * 1e9 + sharpness;
  const counts: Map<string, number> = new Map();
  /** Place of each photo among the frames of its shot, the best first. */
  const places = new Map(
    [...photos]
      .sort((a, b) => rank(b) - rank(a))
      .map(({ id }) => {
        const shot = shotOf(album, id);
        const place = shot === null ? 0 : (counts.get(shot) ?? 0);
        if (shot !== null) counts.set(shot, place + 1);
        return [id, place] as const;
      }),
  );
  const place = ({ id }: PhotoMeta) => places.get(id) ?? 0;
  const most = Math.max(0, ...places.values());
  for (let limit = 0; limit < most; limit += 1) {
    const kept = photos.filter((photo) => place(photo) <= limit);
    if (kept.length >= least) return kept;
  }
  return [...photos];
}
