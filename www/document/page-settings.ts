/** Size, gutter, paper and the like: of all pages of a storyboard alike. */

import { sheetsOf } from './sheets.ts';
import type { PageDocument, PageSettings } from '../engine/types.ts';
import type { Plan } from './pages.ts';
import type { Store } from './store.ts';

const KEEP_ALL = Object.freeze({ layout: true, style: true, photos: true });

export function createPageSettings({ store, plan }: { store: Store; plan: Plan }) {
  return { changeSettings, fitted };

  /** @param gesture names one drag of a control, which is one step of the undo */
  function changeSettings(wish: Partial<PageSettings>, gesture?: string) {
    const project = store.project.peek();
    const { settings, page, at } = project;
    const changed = { ...settings, ...wish };
    const sheets = sheetsOf(project).map((sheet) => ({ ...sheet, page: onPaper(sheet.page, changed) }));
    store.change({ type: 'change-settings', settings: changed, page: page && sheets[at].page, gesture });
    if (sheets.length > 1) store.change({ type: 'set-sheets', sheets, at, silent: true });
  }

  /** A page that was shown before, on the paper that the storyboard has now; one that is alone brings its own. */
  function fitted(page: PageDocument): PageDocument {
    const { settings, others } = store.project.peek();
    const same = Object.entries(settings).every(([field, value]) => page.page[field as keyof PageSettings] === value);
    return others.length === 0 || same ? page : onPaper(page, settings);
  }

  function onPaper(page: PageDocument, changed: PageSettings): PageDocument {
    const resized = changed.width * page.page.height !== changed.height * page.page.width;
    // Another aspect may not suit the layout; the planner then takes one that does, unless it is locked.
    const keep = { ...KEEP_ALL, layout: !resized || store.project.peek().locks.layout || suits(page, changed) };
    const own = store.photos.peek().filter(({ id }) => page.panels.some(({ photo }) => photo === id));
    const alone = store.sheets.peek().length <= 1;
    // The photos of a page among others stay on it, whatever layout it gets.
    const cast = alone || own.length === 0 ? {} : { photos: own, ...(keep.layout ? {} : { panels: own.length }) };
    return plan({ keep, current: page, page: changed, seed: page.seed, ...cast }) ?? { ...page, page: changed };
  }

  /** Whether a layout is as good on another page as it is on its own. */
  function suits(page: PageDocument, changed: PageSettings) {
    const planner = store.planner.peek();
    return (
      !planner || planner.layoutFacts(page.layout, changed).good || !planner.layoutFacts(page.layout, page.page).good
    );
  }
}
