/** Export of pages. */

import { lazyDialog } from '../ui/lazy.tsx';
import { createDownload } from './download.ts';
import { createDownloadActions } from './download-actions.ts';
import { createExportChoice } from './export-choice.ts';
import type { Download } from './download.ts';
import type { ExportChoice } from './export-choice.ts';
import type { Feature, App } from '../ui/context.ts';

type Parts = {
  download: Download;
  exportChoice: ExportChoice;
};

declare module '../ui/context.ts' {
  interface App extends Parts {}
  interface Actions extends ReturnType<typeof actions> {}
}

const actions = (app: App) => ({ download: createDownloadActions(app) });

export const exportFeature: Feature<Parts> = {
  install: (app) => ({
    download: createDownload({
      ...app,
      pageFiles: app.keeping.pageFiles,
      shotList: app.boards.shotList,
      // Storyboard sheets do not count as preferred layouts.
      onSaved: (saved) => saved.filter(app.boards.isComic).forEach(app.taste.learn),
    }),
    exportChoice: createExportChoice(() => app.env.window.localStorage),
  }),
  screens: {
    export: lazyDialog(async () => (await import('./export-dialog.tsx')).ExportDialog),
  },
  actions,
};
