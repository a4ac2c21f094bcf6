/** Pages as the bytes of one file, of each kind that there is. */

import { strings } from '../strings/strings.ts';
import { FORMATS, isArchive, pageName } from './formats.ts';
import { archiveOf } from '../storage/files/archive.ts';
import type { Store } from '../document/store.ts';
import type { PageDocument } from '../engine/types.ts';
import type { Engine } from '../engine/engine.ts';
import type { Format, Inside } from './formats.ts';

export type Work = { signal: AbortSignal; onProgress: (done: number, total: number) => void };
/** What every PNG of a whole page passes through before it leaves. */
export type Carry = (png: Blob, page: PageDocument) => Promise<Blob>;
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
    carry: Carry,
  ): Promise<Blob> {
    if (format === 'pdf')
      return engine.exportPdf(documents, { ...how, quality, title: store.project.peek().name || strings.name });
    if (!isArchive(format)) return picture(documents[0], format as 'png' | 'jpeg' | 'webp', quality, how, carry);
    const entries = [];
    for (const [i, document] of documents.entries()) {
      // Each page has the same share of the whole.
      const onProgress = (done: number, total: number) => how.onProgress(i + done / total, documents.length);
      const blob = await picture(document, inside, quality, { ...how, onProgress }, carry);
      entries.push({ name: pageName(i, documents.length, inside), blob });
    }
    return new Blob([await archiveOf(entries)], { type: FORMATS[format].type });
  }

  async function picture(
    document: PageDocument,
    format: 'png' | 'jpeg' | 'webp',
    quality: number,
    how: Work,
    carry: Carry,
  ) {
    if (format === 'jpeg') return engine.exportJpeg(document, { ...how, quality });
    if (format === 'webp') return engine.exportWebp(document, { ...how, quality });
    return carry(await engine.exportPng(document, how), document);
  }
}
