/**
 * Exports a project that cannot be opened: its photos and the remains of its document, for a newer Inkpanel or for
 * manual recovery.
 */

import { inBlobs } from './database.ts';
import { archiveOf } from '../engine/archive.ts';
import { projectFileName, packedProject, videoKey } from './files/project-file.ts';
import { nameOf } from './restoring.ts';
import { expanded, recordIn } from '../engine/interned.ts';
import { isBytes } from './state-records.ts';
import type { Database } from './database.ts';

export async function rescued(database: Database, id: string): Promise<{ file: Blob; name: string }> {
  const [project, state, name] = await Promise.all([
    database.get('projects', id),
    database.get('states', id),
    nameOf(database, id),
  ]);
  const videos = listOf(state?.videos);
  const keys = new Set(
    [project?.held, project?.refs, state?.facts, videos.map((video) => video?.fileKey)]
      .flatMap((keys) => listOf(keys))
      .filter((key) => typeof key === 'string'),
  );
  const found = await Promise.all([...keys].map((key) => database.get('photos', key)));
  const records = found.flatMap((record) => (record ? inBlobs(record) : [])).filter(({ file }) => file instanceof Blob);
  const files = new Map(records.map((record) => [String(record?.id), record?.file as Blob] as const));
  try {
    const { version, history } = isBytes(state?.bytes) ? wholeOf(recordIn(state.bytes)) : (state ?? {});
    if (!state || !history) throw new TypeError('There is no document.');
    const facts = (await Promise.all(listOf(state.facts).map((key) => database.get('facts', key)))).flatMap((record) =>
      record && files.has(record.id) ? [record.fact] : [],
    );
    const films = videos.flatMap(({ fileKey, ...video }) => {
      const file = files.get(fileKey);
      return file ? [{ ...video, file }] : [];
    });
    const blobs = new Map([...files, ...films.map(({ key, file }) => [videoKey(key), file] as const)]);
    const { file } = await packedProject({ history, facts, videos: films }, blobs, { version });
    return { file, name: projectFileName(name) };
  } catch {
    // Not even its parts are what they should be.
    const entries = [{ name: 'project.json', blob: new Blob([textOf({ format: 'inkpanel', project, state })]) }];
    for (const [i, record] of records.entries()) {
      entries.push({
        name: `photos/${String(i + 1).padStart(3, '0')}-${String(record?.name)
          .replaceAll(/[^\p{L}\p{N}._-]+/gu, '-')
          .slice(-60)}`,
        blob: record?.file as Blob,
      });
    }
    return {
      file: new Blob([await archiveOf(entries)], { type: 'application/zip' }),
      name: projectFileName(name),
    };
  }
}

function wholeOf({ version, history }: ReturnType<typeof recordIn>) {
  return { version, history: expanded(history) };
}

function listOf<Item>(value: readonly Item[] | undefined): readonly Item[] {
  return Array.isArray(value) ? value : [];
}

/** @returns the value as JSON, as far as possible */
function textOf(value: unknown): string {
  const told = (part: unknown) => {
    if (isBytes(part)) return new TextDecoder().decode(part);
    return typeof part === 'bigint' || part instanceof Map || part instanceof Set ? String(part) : part;
  };
  try {
    return JSON.stringify(value, (_, part) => told(part), 1);
  } catch {
    return String(value);
  }
}
