/**
 * What a downloaded page tells of itself: the page with its layout, style, crops and words, and of its photos how they
 * are recognised. The shape is that of `project.json`, so the same checks and migrations hold. Names of files, ids and
 * times stay here: the same page gives the same text wherever it is made.
 */

import { EMPTY_PROJECT } from '../../document/empty.ts';
import { hashOf, strippedOf } from '../../photos/identity.ts';
import { projectJson } from './project-json.ts';
import type { Album } from '../../document/album.ts';
import type { PageDocument, Project } from '../../document/project.ts';

/**
 * @param page as it is drawn, which may be in another size than the project has it
 * @param photos `fileOf`: null of a photo that is not here
 * @returns `files`: the photos that are
 *   here under the names that the text has for them, without what cameras write; `unclean`: those of a kind that keeps it
 */
export async function pageJson(
  project: Project,
  page: PageDocument,
  { album, fileOf }: { album: Album; fileOf: (id: string) => Blob | null },
): Promise<{ json: string; files: { name: string; blob: Blob }[]; unclean: number }> {
  const shown = new Set(page.panels.map(({ photo }) => photo));
  const facts = project.tray
    .flatMap(({ id }) => (shown.has(id) ? (album.get(id) ?? []) : []))
    .filter(({ meta }) => meta !== null);
  // No words on the page are like these: texts that are ids are renamed where the page is opened.
  const ids = new Map(facts.map(({ id }, i) => [id, `#photo-${i + 1}`]));
  const idOf = (id: string) => ids.get(id) as string;

  const told = [];
  const blobs = new Map();
  let unclean = 0;
  for (const { id, credit, meta, measures, looked, absent } of facts) {
    const file = absent ? null : fileOf(id);
    const known = meta as NonNullable<typeof meta>;
    const { fingerprint, width, height } = known;
    if (file) {
      const { blob, clean } = await strippedOf(file);
      blobs.set(idOf(id), blob);
      unclean += clean ? 0 : 1;
    }
    const about = { id: idOf(id), name: idOf(id).slice(1), credit, type: '' };
    // A photo that is missing here is told of as where the page came from.
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
  const drawn = {
    ...page,
    order: page.order.flatMap((id) => ids.get(id) ?? []),
    panels: page.panels.map((panel) => ({ ...panel, photo: ids.get(panel.photo ?? '') ?? null })),
  };
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
    page: drawn,
    pageId: 1,
  };
  const { json, paths } = projectJson({ present, shown: [] }, told, []);
  const files = [...paths].flatMap(([id, path]) => (blobs.has(id) ? { name: path, blob: blobs.get(id) } : []));
  return { json, files, unclean };
}
