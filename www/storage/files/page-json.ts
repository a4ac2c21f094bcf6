/**
 * Project data in a downloaded page: its storyboard with layouts, styles, crops and text, and fingerprints of its
 * photos. The format is `project.json`, so the same checks and migrations apply. File names, ids and times are not
 * included: the same page gives the same text on every device.
 */

import type { Album } from '../../document/album.ts';
import { EMPTY_PROJECT } from '../../document/empty.ts';
import type { PageDocument, Project } from '../../document/project.ts';
import { photosOn, sheetsOf } from '../../engine/sheets.ts';
import type { Word } from '../../engine/types.ts';
import { hashOf, strippedOf } from '../../photos/identity.ts';
import type { Work } from '../../engine/archive.ts';
import { projectJson } from './project-json.ts';

/**
 * @param page the present page as drawn, possibly in another size than in the project
 * @param photos `fileOf`: null of a photo that is not here; `onProgress` counts them
 * @returns `files`: the available photos by their names in the text, without metadata; `unclean`: photos whose format
 *   keeps metadata
 */
export async function pageJson(
  project: Project,
  page: PageDocument,
  { album, fileOf, signal, onProgress }: { album: Album; fileOf: (id: string) => Blob | null } & Work,
): Promise<{ json: string; files: { name: string; blob: Blob }[]; unclean: number }> {
  const pages = pagesWith(project, page);
  const shown = photosOn(pages);
  const facts = project.tray
    .flatMap(({ id }) => (shown.has(id) ? (album.get(id) ?? []) : []))
    .filter(({ meta }) => meta !== null);
  // No text on the page equals such an id, because opening a page renames all texts that are ids.
  const ids = new Map(facts.map(({ id }, i) => [id, `#photo-${i + 1}`]));
  const idOf = (id: string) => ids.get(id) as string;

  const told = [];
  const blobs = new Map();
  let unclean = 0;
  for (const { id, credit, meta, measures, looked, absent } of facts) {
    signal?.throwIfAborted();
    onProgress?.(told.length, facts.length);
    const file = absent ? null : fileOf(id);
    const known = meta as NonNullable<typeof meta>;
    const { fingerprint, width, height } = known;
    if (file) {
      const { blob, clean } = await strippedOf(file);
      blobs.set(idOf(id), blob);
      unclean += clean ? 0 : 1;
    }
    const about = { id: idOf(id), name: idOf(id).slice(1), credit, type: '' };
    // A missing photo keeps its metadata from the original page.
    told.push(
      absent
        ? {
            ...about,
            like: absent,
            meta: { ...known, subjects: absent.subjects ?? [] },
            measures: absent.measured ? {} : null,
            looked: absent.subjects !== null,
          }
        : {
            ...about,
            like: { hash: file ? await hashOf(file) : '', fingerprint, width, height },
            meta: known,
            measures,
            looked,
          },
    );
  }

  const tray = project.tray
    .filter(({ id }) => ids.has(id))
    .map(({ id, focus }) => ({ id: idOf(id), use: true, ...(focus ? { focus } : {}) }));
  const { name, alike, order, locks, panels, styling } = project;
  const drawn = pages.map((page) => ({
    ...page,
    order: page.order.flatMap((id) => ids.get(id) ?? []),
    panels: page.panels.map((panel) => ({ ...panel, photo: ids.get(panel.photo ?? '') ?? null })),
    words: page.words.map((word) => wordOf(word, ids)),
  }));
  const present = {
    ...EMPTY_PROJECT,
    name,
    alike,
    order,
    locks,
    panels,
    styling,
    tray,
    settings: page.page,
    ...numbered(drawn, project.page ? project.at : 0),
  };
  const { json, paths } = projectJson({ present, shown: [] }, told, []);
  const files = [...paths].flatMap(([id, path]) => (blobs.has(id) ? { name: path, blob: blobs.get(id) } : []));
  return { json, files, unclean };
}

/**
 * A text item with the name of its photo in the file. If its photo is on no page, the item belongs only to its panel.
 */
function wordOf({ photo, ...word }: Word, ids: ReadonlyMap<string, string>): Word {
  const name = ids.get(photo ?? '');
  return name === undefined ? word : { ...word, photo: name };
}

/** Pages as the storyboard of a project, with ids that do not reveal its history. */
export function numbered(pages: readonly PageDocument[], at: number) {
  const sheets = pages.map((page, i) => ({ page, pageId: i + 1, sheet: i }));
  return { ...sheets[at], others: sheets.toSpliced(at, 1), at };
}

/**
 * Returns the pages of a project, with the current page in its drawn form. If its resolution differs on the same paper,
 * the other pages are converted, so that they stay one storyboard.
 */
function pagesWith(project: Project, page: PageDocument): PageDocument[] {
  const sheets = sheetsOf(project).map((sheet) => sheet.page);
  const own = sheets[project.at]?.page;
  if (!own) return [page];
  const { width, height, dpi } = page.page;
  const sameSide = ({ width: w, height: h }: typeof own) => w === own.width && h === own.height;
  const scaled =
    (width !== own.width || height !== own.height) && Math.abs((width / height) * (own.height / own.width) - 1) < 0.01;
  return sheets.map((other, i) => {
    if (i === project.at) return page;
    return scaled && sameSide(other.page) ? { ...other, page: { ...other.page, width, height, dpi } } : other;
  });
}
