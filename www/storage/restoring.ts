/**
 * A project out of the database. Stored data is untrusted: the core checks the document, and invalid records count as
 * missing.
 */

import { inBlobs } from './database.ts';
import { failure } from '../engine/protocol.ts';
import { strings } from '../strings/strings.ts';
import { sheetsOf } from '../engine/sheets.ts';
import { drawnId } from './drawn-states.ts';
import { emptyFrames } from '../photos/placeholder.ts';
import { openEditing } from '../document/editing.ts';
import { bytesOf } from '../engine/interned.ts';
import { photosOf } from './snapshot.ts';
import { bytesIn } from './state-records.ts';
import type { Fact, Video } from '../document/album.ts';
import type { Editing } from '../document/editing.ts';
import type { Beginning } from '../document/history.ts';
import type { Project } from '../document/project.ts';
import type { Planner } from '../document/store.ts';
import type { Database, KeptVideo, PhotoRecord, ProjectRecord, StateRecord } from './database.ts';
import type { Journal } from './journal.ts';
import type { Place } from '../document/place.ts';

type Ready = Promise<Planner>;

/**
 * Parts of a stored project:
 *
 * - `editing`: the editor with its history; or `history`, if it has no undo steps; an empty project without both
 * - `records`: photo records of the database
 * - `unread`: files that must be decoded again
 * - `films`: keys of videos that must be decoded again for their frames
 * - `missing`: photos in the tray that are empty frames
 * - `filmless`: names of missing videos, whose frames exist
 * - `dropped`: parts that could not be read
 */
export type Content = {
  history?: Beginning;
  editing?: Editing;
  album: ReadonlyMap<string, Fact>;
  videos: ReadonlyMap<string, Video>;
  records: PhotoRecord[];
  unread: { id: string; file: File }[];
  films?: string[];
  missing?: { id: string; name: string }[];
  filmless?: string[];
  dropped?: readonly string[];
};

/**
 * @param recall returns edits from the journal that are not in the database
 * @returns rejects with `missing-project`, `damaged-project` or `newer-project`
 */
export async function readProject(
  database: Database,
  id: string,
  ready: Ready,
  recall: Journal['recall'] = () => null,
): Promise<{ place: Place; content: Content; drawn: Project[] }> {
  const [place, state] = await Promise.all([placeOf(database, id), database.get('states', id)]);
  if (!state) throw failure('missing-project', 'This project no longer exists.');
  const planner = await ready;
  const bytes = bytesIn(state);
  const told = recall(id, place.stamp);
  const newer = told && replayed(planner, bytes, told.changes);
  const editing = newer ?? openEditing(planner.createEditor(), bytes);
  const drawn = await drawnOf(database, id, ready);
  const content = await contentOf(database, {
    ids: new Set([...editing.photos(), ...photosOf(drawn)]),
    present: editing.mirror().present,
    state,
    names: new Map(newer && told?.photos),
  });
  return {
    place: newer ? { ...place, behind: 'journal' } : place,
    content: { ...content, editing, dropped: editing.dropped },
    drawn,
  };
}

/** @returns an editor with the changes of the journal; null if they do not fit */
function replayed(planner: Planner, bytes: Uint8Array<ArrayBuffer>, changes: readonly string[]): Editing | null {
  try {
    const editing = openEditing(planner.createEditor(), bytes, changes);
    return editing.dropped.length > 0 ? null : editing;
  } catch {
    return null;
  }
}

/** @returns the states of a project that were drawn and can be read, the last at the end */
export async function drawnOf(database: Database, id: string, ready: Ready): Promise<Project[]> {
  const { drawn, version } = (await database.get('states', drawnId(id))) ?? {};
  if (!Array.isArray(drawn)) return [];
  const planner = await ready;
  return drawn.flatMap((present: unknown) => {
    try {
      const history = { past: [], present, future: [], shown: [] };
      return [openEditing(planner.createEditor(), bytesOf({ version, history })).mirror().present];
    } catch {
      return [];
    }
  });
}

/** A project in a state that it had. */
export async function readState(
  database: Database,
  id: string,
  state: Project,
): Promise<{ place: Place; content: Content }> {
  const [place, kept] = await Promise.all([placeOf(database, id), database.get('states', id)]);
  const content = await contentOf(database, { ids: photosOf([state]), present: state, state: kept });
  return { place: { ...place, behind: 'wholly' }, content: { ...content, history: beginningWith(state) } };
}

/** with only this state */
export function beginningWith(state: Project): Beginning {
  const shown = sheetsOf(state).map(({ page, pageId, sheet }) =>
    sheet === 0 ? { id: pageId, page } : { id: pageId, page, sheet },
  );
  return { present: state, shown };
}

/** whether the project exists and is not deleted */
export async function isThere(database: Database, id: string): Promise<boolean> {
  const project = await database.get('projects', id);
  return project ? !isGone(project) : (await database.getKey('states', id)) !== undefined;
}

export function isGone({ gone }: ProjectRecord) {
  return typeof gone === 'number';
}

/** @returns the name of the project */
export async function nameOf(database: Database, id: string): Promise<string> {
  return textOr((await database.get('projects', id))?.name, '');
}

/** Keeps the photos of a state that cannot be drawn until the project is deleted. */
export async function holdPhotos(database: Database, id: string) {
  const all = database.transaction(['projects', 'states'], 'readwrite');
  const [project, state] = await Promise.all([all.objectStore('projects').get(id), all.objectStore('states').get(id)]);
  if (project) {
    const keys = [
      ...textsIn(project.held),
      ...textsIn(project.refs),
      ...textsIn(state?.facts),
      ...videosIn(state).map(({ fileKey }) => fileKey),
    ];
    await all.objectStore('projects').put({ ...project, held: [...new Set(keys)] });
  }
  await all.done;
}

async function placeOf(database: Database, id: string): Promise<Place> {
  const project = await database.get('projects', id);
  return {
    id,
    stamp: textOr(project?.stamp, ''),
    created: Number.isFinite(project?.created) ? Number(project?.created) : Date.now(),
  };
}

/**
 * Restores photos. Photos without copies or measurements are read again from their files, frames
 * from their videos. If the file is missing, an empty frame keeps their place.
 * @param about `ids` of its photos; `present`; `state`: the stored state; `names`: photo names in the journal
 */
async function contentOf(
  database: Database,
  {
    ids: all,
    present,
    state,
    names = new Map(),
  }: {
    ids: ReadonlySet<string>;
    present: Project;
    state: Partial<StateRecord> | undefined;
    names?: ReadonlyMap<string, string>;
  },
): Promise<Omit<Content, 'history' | 'editing'>> {
  const ids = [...all];
  const kept = videosIn(state);
  const turn = database.transaction(['photos', 'facts']);
  const [photos, factsOf] = [turn.objectStore('photos'), turn.objectStore('facts')];
  const [found, told, films] = await Promise.all([
    there(ids.map((id) => photos.get(id))),
    there(ids.map((id) => factsOf.get(id))),
    there(kept.map(({ fileKey }) => photos.get(fileKey))),
  ]);
  const [records, files] = [found.map(asRecord), films.map(asRecord)];
  const facts = told.flatMap(({ id, fact }) => (isFact(fact, id) ? [fact] : []));
  const filmOf = new Map(files.map((record) => [record.id, record.file]));
  const videos = kept.flatMap(({ fileKey, ...video }) => {
    const file = filmOf.get(fileKey);
    return file ? [{ ...video, file: asFile(file, video.name) }] : [];
  });
  const { album, unread, frames, missing } = photosFrom(ids, { records, facts, videos, names });
  const empty = await emptyFrames(missing);
  for (const { fact } of empty) album.set(fact.id, fact);
  const inTray = new Set(present.tray.map(({ id }) => id));
  return {
    album,
    videos: new Map(videos.map((video) => [video.key, video])),
    records: [...records, ...files],
    unread: [...unread, ...empty.map(({ fact: { id }, file }) => ({ id, file }))],
    films: frames,
    filmless: kept.flatMap(({ fileKey, name }) => (filmOf.get(fileKey) ? [] : name)),
    missing: missing.flatMap(({ id, name }) => (inTray.has(id) ? { id, name } : [])),
  };
}

async function there<Found>(asked: Promise<Found | undefined>[]): Promise<Found[]> {
  return (await Promise.all(asked)).flatMap((found) => (found ? [found] : []));
}

function photosFrom(
  ids: readonly string[],
  {
    records,
    facts,
    videos,
    names,
  }: {
    records: readonly PhotoRecord[];
    facts: readonly Fact[];
    videos: readonly Video[];
    names: ReadonlyMap<string, string>;
  },
) {
  const [byId, factOf] = [
    new Map(records.map((record) => [record.id, record])),
    new Map(facts.map((fact) => [fact.id, fact])),
  ];
  const filmOf = new Map(videos.flatMap((video) => video.ids.map((id) => [id, video.key])));
  const album: Map<string, Fact> = new Map();
  const unread: Content['unread'] = [];
  const missing: Fact[] = [];
  const frames: Set<string> = new Set();
  for (const id of ids) {
    const record = byId.get(id);
    const { file = null, work = null, small = null } = record ?? {};
    const name = names.get(id) ?? record?.name ?? strings.absentPhoto({ n: missing.length + 1 });
    const fact = factOf.get(id) ?? { id, name, meta: null, measures: null };
    album.set(id, fact);
    const film = filmOf.get(id);
    if (fact.meta && work && small) continue;
    if (file) unread.push({ id, file: asFile(file, fact.name) });
    else if (film !== undefined && !fact.absent) frames.add(film);
    else missing.push(fact);
  }
  return { album, unread, frames: [...frames], missing };
}

/** @param record out of the database */
function asRecord(record: PhotoRecord): PhotoRecord {
  const { id, name, file, work, small } = inBlobs(record);
  return {
    id,
    name: textOr(name, 'photo'),
    file: file instanceof Blob ? file : null,
    work: isHandle(work) ? work : null,
    small: isHandle(small) ? small : null,
  };
}

function isHandle(handle: PhotoRecord['work']) {
  return (
    typeof handle?.key === 'string' && isSide(handle.width) && isSide(handle.height) && handle.planes instanceof Blob
  );
}

function isFact(fact: Fact, id: string) {
  if (fact?.id !== id || typeof fact.name !== 'string') return false;
  const { meta, measures } = fact;
  if (meta === null) return true;
  return (
    meta?.id === id &&
    isSide(meta.width) &&
    isSide(meta.height) &&
    /^[0-9a-f]{16}$/.test(meta.fingerprint) &&
    Number.isFinite(meta.sharpness) &&
    (meta.taken === null || typeof meta.taken === 'string') &&
    typeof meta.energy?.values === 'string' &&
    Array.isArray(meta.subjects) &&
    (measures === null || typeof measures === 'object')
  );
}

function isSide(side: unknown) {
  return Number.isSafeInteger(side) && Number(side) > 0;
}

function videosIn(state: Partial<StateRecord> | undefined): KeptVideo[] {
  const list = Array.isArray(state?.videos) ? state.videos : [];
  return list.filter(
    (video) =>
      [video?.key, video?.name, video?.fileKey].every((text) => typeof text === 'string') &&
      Array.isArray(video.ids) &&
      [video.duration ?? 0, video.start, video.end ?? 0].every(Number.isFinite),
  );
}

function textsIn(list: unknown): string[] {
  return Array.isArray(list) ? list.filter((text) => typeof text === 'string') : [];
}

function textOr(text: unknown, other: string) {
  return typeof text === 'string' ? text : other;
}

function asFile(blob: Blob, name: string) {
  return blob instanceof File ? blob : new File([blob], name, { type: blob.type });
}
