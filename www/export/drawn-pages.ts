import { overlapped } from '../engine/overlap.ts';
import type { PageDocument } from '../engine/types.ts';
import type { Work } from './page-making.ts';

/**
 * Draws pages. Each has the same share of the progress.
 * @returns the pictures, in the order of the pages
 */
export function drawnPages(
  documents: readonly PageDocument[],
  how: Work,
  draw: (document: PageDocument, how: Work) => Promise<Blob>,
): Promise<Blob[]> {
  const shares = documents.map(() => 0);
  return overlapped(documents, (document, i) => {
    const onProgress = (done: number, total: number) => {
      shares[i] = done / total;
      how.onProgress(
        shares.reduce((sum, share) => sum + share, 0),
        documents.length,
      );
    };
    return draw(document, { ...how, onProgress });
  });
}
