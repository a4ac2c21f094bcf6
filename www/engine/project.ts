/** A project for other sites: the editor of the core with its history as plain data. */

import { bytesOf, expanded, recordIn } from './interned.ts';
import { VERSION } from './versions.ts';
import type { Planner, Wish } from './core.ts';
import type { Draw, Edit, History, How, PageDocument, PhotoMeta, Project } from './types.ts';

export type ProjectEditor = ReturnType<typeof createProject>;

/**
 * An empty project, or a saved one.
 * @param planner `await engine.ready`
 * @param history from `history()`; throws `damaged-project` or `newer-project`
 */
export function createProject(planner: Planner, history?: History) {
  const editor = planner.createEditor();
  let { pageId } = history ? editor.load(bytesOf({ version: VERSION, history })) : { pageId: 0 };
  let now = saved();
  let photos: PhotoMeta[] = [];

  return {
    /** The current project: its photos, pages, settings. */
    project: (): Project => now.present,
    /** The complete history as plain data for saving. */
    history: (): History => now,
    edit,
    undo: () => edit({ type: 'undo' }),
    redo: () => edit({ type: 'redo' }),
    /**
     * Adds photos.
     * @param fresh from `importPhoto`
     */
    addPhotos: (fresh: readonly PhotoMeta[]) => {
      photos = [...photos, ...fresh];
      return edit({ type: 'add-photos', ids: fresh.map(({ id }) => id) });
    },
    /**
     * Plans a page of the photos in use and shows it, as one step of undo.
     * @param wish a seed, and the locked parts: layout, style, photos; everything else is random
     * @returns null without photos
     */
    shuffle: ({
      keep = { layout: false, style: false, photos: false },
      ...wish
    }: Omit<Wish, 'keep'> & Partial<Pick<Wish, 'keep'>> & Pick<Draw, 'seed'>): PageDocument | null => {
      const page = editor.plans(inUse()).page({ ...wish, keep });
      if (page) edit({ type: 'show-page', page, pageId });
      return page;
    },
  };

  function inUse(): PhotoMeta[] {
    const used = new Set(now.present.tray.flatMap(({ id, use }) => (use === false ? [] : [id])));
    return photos.filter(({ id }) => used.has(id));
  }

  /**
   * Applies an edit. Throws `invalid-document`, or an error of the planner, without any change.
   * @param change `silent`: without an undo step; `gesture`: joins earlier steps with the same name
   * @returns the project after it
   */
  function edit(change: Edit & How): Project {
    ({ pageId } = editor.apply(JSON.stringify(change), inUse()));
    now = saved();
    return now.present;
  }

  function saved(): History {
    return expanded(recordIn(editor.save()).history);
  }
}
