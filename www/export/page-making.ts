/** Pages as the bytes of one file, of each kind that there is. */

import { strings } from '../strings/strings.ts';
import { FORMATS, isArchive, pageName } from './formats.ts';
import { archiveOf } from '../storage/files/archive.ts';
import type { Store } from '../document/store.ts';
import type { PageDocument } from '../engine/types.ts';
import type { Engine } from '../engine/engine.ts';
import type { Format, Inside } from './formats.ts';

export type Work = { signal: AbortSignal; onProgress: (done: number, total: number) => void };
/**
 * What goes with pages before they leave: `carry` puts it into the PNG of a page, `beside` gives what lies beside the pages
 * of an archive, if anything.
 */
export type Cargo = {
  carry: (png: Blob, page: PageDocument, how: Work) => Promise<Blob>;
  beside: (how: Work) => Promise<{ name: string; blob: Blob } | null>;
};
/** `quality` from 1 to 100 */
export type Wish = { pages: readonly PageDocument[]; format: Format; inside?: Inside; quality?: number };

export const USUAL_QUALITY = 88;

export function createMaking({
  store,
  engine,
}: {
  store: Store;
  engine: Pick<Engine, 'exportPng' | 'exportJpeg' | 'exportWebp' | 'exportPdf'>;
}) {
  return make;

  async function make(
    { pages: documents, format, inside = 'png', quality = USUAL_QUALITY }: Wish,
    how: Work,
    { carry, beside }: Cargo,
  ): Promise<Blob> {
    if (format === 'pdf')
      return engine.exportPdf(documents, { ...how, quality, title: store.project.peek().name || strings.name });
    if (!isArchive(format)) return picture(documents[0], format as 'png' | 'jpeg' | 'webp', quality, how, carry);
    const entries = [];
    for (const [i, document] of documents.entries()) {
      // Each page has the same share of the whole.
      const onProgress = (done: number, total: number) => how.onProgress(i + done / total, documents.length);
      const blob = await picture(document, inside, quality, { ...how, onProgress }, async (png) => png);
      entries.push({ name: pageName(i, documents.length, inside), blob });
    }
    const project = await beside(how);
    if (project) entries.push(project);
    return new Blob([await archiveOf(entries, { signal: how.signal })], { type: FORMATS[format].type });
  }

  async function picture(
    document: PageDocument,
    format: 'png' | 'jpeg' | 'webp',
    quality: number,
    how: Work,
    carry: Cargo['carry'],
  ) {
    if (format === 'jpeg') return engine.exportJpeg(document, { ...how, quality });
    if (format === 'webp') return engine.exportWebp(document, { ...how, quality });
    return carry(await engine.exportPng(document, how), document, how);
  }
}
