/**
 * `project.json` of a project file: the document, the page history, and metadata of each photo and video. Undo states
 * are not included. The core reads it (`readProject`). The photos are measured again.
 */

import { freshId } from '../../document/fresh-id.ts';
import { VERSION } from '../../engine/versions.ts';
import type { Fact, Video } from '../../document/album.ts';
import type { Planner } from '../../document/store.ts';
import type { Beginning } from '../../document/history.ts';
import type { FilePhoto, FileVideo, Likeness } from '../../engine/types.ts';

export type { FilePhoto };
/** `dropped`: the dropped parts with reasons */
export type FileProject = {
  history: Beginning;
  photos: readonly FilePhoto[];
  videos: readonly FileVideo[];
  dropped: readonly string[];
};

const FORMAT = 'inkpanel';

/**
 * @param facts with the types of their files
 * @param version of the history, if it is not the newest version
 * @returns `paths`: path of each photo in the file by id, and of each video by `video` and its key
 */
export function projectJson(
  { present, shown }: Beginning,
  facts: readonly (Omit<Fact, 'measures'> & { measures: object | null; type: string; like?: Likeness })[],
  videos: readonly (Omit<Video, 'file'> & { file: Blob })[],
  version: number = VERSION,
): { json: string; paths: Map<string, string> } {
  const paths: Map<string, string> = new Map();
  const place = (id: string, folder: string, name: string) => {
    const path = `${folder}/${String(paths.size + 1).padStart(3, '0')}-${name.replaceAll(/[^\p{L}\p{N}._-]+/gu, '-').slice(-60)}`;
    paths.set(id, path);
    return path;
  };
  // Capture times are private, so only their order is stored.
  const times = [...new Set(facts.flatMap(({ meta }) => meta?.taken ?? []))].sort();
  const photos = facts.map(({ id, name, credit, video, time, shot, meta, measures, looked, type, absent, like }) => ({
    id,
    name,
    credit,
    video,
    time,
    shot,
    path: place(id, 'photos', name),
    type,
    measured: measures !== null,
    subjects: absent ? absent.subjects : looked && meta ? meta.subjects : null,
    mask: meta?.mask,
    rank: meta?.taken ? times.indexOf(meta.taken) : undefined,
    like: absent ? likenessOf(absent) : like && likenessOf(like),
    absent: absent ? true : undefined,
  }));
  const films = videos.map(({ file, ...video }) => ({
    ...video,
    path: place(`video ${video.key}`, 'videos', video.name),
    type: file.type,
  }));
  const history = { present, shown };
  return { json: JSON.stringify({ format: FORMAT, version, history, photos, videos: films }, null, 1), paths };
}

/**
 * Reads a project. Its photos get new ids that are unique in this browser, because a file may be opened twice or
 * edited.
 * @returns throws `damaged-project` or `newer-project`
 */
export function readProjectJson(text: string, planner: Pick<Planner, 'readProject'>): FileProject {
  return planner.readProject(text, { prefix: `p${freshId(8)}-` });
}

/** @returns only these fields */
function likenessOf({ hash, fingerprint, width, height }: Likeness): Likeness {
  return { hash, fingerprint, width, height };
}

/**
 * @param taken capture time in the file, as in older project files
 * @returns something that sorts as the times do
 */
export function takenBy({ rank }: FilePhoto, taken: string | null): string | null {
  return rank === null ? taken : String(rank).padStart(9, '0');
}

/** @returns the same data with new names in all texts that are old names */
export function renamed<T>(value: T, names: ReadonlyMap<string, string>): T {
  const change = (part: unknown): unknown => {
    if (typeof part === 'string') return names.get(part) ?? part;
    if (Array.isArray(part)) return part.map(change);
    if (typeof part !== 'object' || part === null) return part;
    return Object.fromEntries(Object.entries(part).map(([key, item]) => [names.get(key) ?? key, change(item)]));
  };
  return change(value) as T;
}
