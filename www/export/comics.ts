/**
 * Digital comics: HTML with a reader, EPUB books, and the metadata of comic archives. The core writes the text. This
 * module inserts the pictures as Blobs, which the browser can store on disk.
 */

import { language, strings } from '../strings/strings.ts';
import { drawnPages } from './drawn-pages.ts';
import { FORMATS, pictureIn } from './formats.ts';
import { describePanel } from '../page/describing.ts';
import { archiveOf } from '../engine/archive.ts';
import type { Store } from '../document/store.ts';
import type { Comic, PageDocument, PictureKind } from '../engine/types.ts';
import type { Engine } from '../engine/engine.ts';
import type { Inside } from './formats.ts';
import type { Animatics } from '../motion/animatics.ts';
import type { MovingPicture } from '../motion/moving-pictures.ts';
import type { Work } from './page-making.ts';

export function createComics({
  store,
  engine,
  movingPictures,
}: {
  store: Pick<Store, 'project' | 'album'>;
  movingPictures: Animatics['movingPictures'];
  engine: Pick<Engine, 'exportJpeg' | 'exportWebp' | 'givesWebp' | 'comicPieces' | 'comicFiles'>;
}) {
  return { book, about };

  /** All pages in one file, with progress by the panels that are drawn. */
  async function book(
    format: 'html' | 'epub',
    documents: readonly PageDocument[],
    quality: number,
    how: Work,
    living: boolean,
  ): Promise<Blob> {
    const kind = pictureIn(format, 'jpeg', await engine.givesWebp());
    const { signal } = how;
    const { type } = FORMATS[format];
    if (format === 'html') {
      // Errors in the text are found before any page is drawn.
      const still = await engine.comicPieces(told(documents, kind), { signal });
      // Animated panels take as long as everything else together.
      const steps = living ? 2 * documents.length : documents.length;
      const onProgress = (done: number) => how.onProgress(done, steps);
      const pictures = await drawn(documents, kind, quality, { signal, onProgress });
      const moving: MovingPicture[][] = [];
      if (living)
        for (const document of documents) {
          moving.push(await movingPictures(document, { signal }));
          onProgress(documents.length + moving.length);
        }
      const moves = moving.some((page) => page.length > 0);
      const pieces = moves ? await engine.comicPieces(told(documents, kind, moving), { signal }) : still;
      const urls: Blob[] = [];
      for (const picture of [...pictures, ...moving.flat().map(({ file }) => file)]) urls.push(await dataUrl(picture));
      return new Blob(
        pieces.map((piece) => (typeof piece === 'number' ? urls[piece] : piece)),
        { type },
      );
    }
    const files = await engine.comicFiles(format, told(documents, kind), { signal });
    const pictures = await drawn(documents, kind, quality, how);
    const entries = files.map(({ name, content }) => ({
      name,
      blob: typeof content === 'number' ? pictures[content] : new Blob([content]),
    }));
    return new Blob([await archiveOf(entries)], { type });
  }

  function drawn(documents: readonly PageDocument[], kind: PictureKind, quality: number, how: Work) {
    const draw = kind === 'webp' ? engine.exportWebp : engine.exportJpeg;
    return drawnPages(documents, how, (document, page) => draw(document, { ...page, quality }));
  }

  /** The metadata files of a comic archive, for comic libraries and readers. */
  async function about(documents: readonly PageDocument[], inside: Inside, { signal }: Work) {
    const files = await engine.comicFiles('cbz', told(documents, inside), { signal });
    return files.flatMap(({ name, content }) =>
      typeof content === 'string' ? [{ name, blob: new Blob([content]) }] : [],
    );
  }

  function told(
    documents: readonly PageDocument[],
    picture: PictureKind,
    moving: readonly (readonly MovingPicture[])[] = [],
  ): Comic {
    const album = store.album.peek();
    return {
      title: store.project.peek().name || strings.name,
      language,
      picture,
      pages: documents.map((document, page) => ({
        document,
        moving: (moving[page] ?? []).map(({ place }) => place),
        shows: document.panels.map((_, panel) => describePanel(document, album, panel)),
      })),
    };
  }
}

/** Returns a picture as a data URL, stored as a Blob. */
function dataUrl(picture: Blob): Promise<Blob> {
  return new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.addEventListener('load', () => resolve(new Blob([reader.result as string])));
    reader.addEventListener('error', () => reject(reader.error));
    reader.readAsDataURL(picture);
  });
}
