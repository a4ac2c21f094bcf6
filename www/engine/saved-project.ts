/** A saved project (`.inkpanel`) opened to be drawn: its pages as documents, their photos in the engine. */

import { readArchive } from './archive.ts';
import { TEXT } from './limits.ts';
import { damaged } from './protocol.ts';
import { photosOn, sheetsOf } from './sheets.ts';
import type { Engine } from './engine.ts';
import type { PageDocument } from './types.ts';

/** `lost`: photos of its pages that are missing or unreadable. Their panels are empty. */
export type SavedProject = { name: string; pages: PageDocument[]; lost: string[]; close: () => void };

let opened = 0;

/**
 * Opens a saved project. Rejects with `damaged-project`, `newer-project` or `too-large-project`, without any change of
 * the engine.
 * @param file from the app or the command line
 * @returns `close` frees its photos
 */
export async function openProject(
  engine: Pick<Engine, 'ready' | 'importPhoto' | 'forgetPhoto'>,
  file: Blob,
  { signal }: { signal?: AbortSignal } = {},
): Promise<SavedProject> {
  const archive = await readArchive(file);
  const text = await archive.get('project.json')?.read({ most: TEXT.project, signal });
  if (!text) throw damaged('project.json is missing');
  // Ids that no other project in this engine has.
  const prefix = `saved-${(opened += 1)}-`;
  const { history, photos } = (await engine.ready).readProject(await text.text(), { prefix });
  const { present } = history;
  const pages = sheetsOf(present).map(({ page }) => page);
  const shown = photosOn(pages);
  const known: string[] = [];
  const close = () => known.splice(0).forEach(engine.forgetPhoto);
  const paths = new Map(photos.map(({ id, path }) => [id, path]));
  try {
    await Promise.all(
      [...shown].map(async (id) => {
        const entry = archive.get(paths.get(id) ?? '');
        try {
          if (!entry) return;
          await engine.importPhoto(id, await entry.read({ signal }), { signal });
          known.push(id);
        } catch (error) {
          // One photo that cannot be read costs its panel, not the page.
          if (signal?.aborted || ['cancelled', 'disposed'].includes((error as { code: string }).code)) throw error;
        }
      }),
    );
  } catch (error) {
    close();
    throw error;
  }
  const here = new Set(known);
  const lost = [...shown].filter((id) => !here.has(id));
  return { name: present.name, pages: pages.map((one) => without(one, here)), lost, close };
}

function without(page: PageDocument, here: ReadonlySet<string>): PageDocument {
  const panels = page.panels.map((panel) =>
    panel.photo && !here.has(panel.photo) ? { ...panel, photo: null } : panel,
  );
  return { ...page, panels };
}
