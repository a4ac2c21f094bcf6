/** Pages as the bytes of one file, of each kind that there is. */

import { strings } from '../strings/strings.ts';
import { createComics } from './comics.ts';
import { drawnPages } from './drawn-pages.ts';
import { FORMATS, isArchive, isBook, isFilm, isList, pageName } from './formats.ts';
import { archiveOf } from '../engine/archive.ts';
import { describePanel } from '../page/describing.ts';
import { currentLanguage } from '../strings/language.ts';
import { bled, kept, NO_PRINT, pdfOptions } from './print.ts';
import type { Animatics, AnimaticWish } from '../motion/animatics.ts';
import type { Store } from '../document/store.ts';
import type { PageDocument, ShotList } from '../engine/types.ts';
import type { Engine } from '../engine/engine.ts';
import type { Format, Inside } from './formats.ts';
import type { Print } from './print.ts';

export type Work = { signal: AbortSignal; onProgress: (done: number, total: number) => void };
/**
 * Data that is added to exported pages. `carry` embeds it in the PNG of a page. `beside` returns additional files of an
 * archive, if any.
 */
export type Cargo = {
  carry: (png: Blob, page: PageDocument, how: Work) => Promise<Blob>;
  beside: (how: Work) => Promise<{ name: string; blob: Blob } | null>;
};
/** `quality` from 1 to 100 */
export type Wish = {
  pages: readonly PageDocument[];
  format: Format;
  inside?: Inside;
  quality?: number;
  /** of a PDF file */
  print?: Print;
  /** Settings of a video. */
  film?: AnimaticWish;
  /** Whether the pages become a vertical strip. */
  strip?: boolean;
  /** HTML comics: whether panels with video frames are animated. */
  living?: boolean;
};

export const USUAL_QUALITY = 88;

export function createMaking({
  store,
  engine,
  shotList,
  animatics,
}: {
  store: Store;
  shotList: () => ShotList;
  animatics: Pick<Animatics, 'film' | 'movingPictures'>;
  engine: Pick<
    Engine,
    | 'exportPng'
    | 'exportJpeg'
    | 'exportWebp'
    | 'exportPdf'
    | 'exportPlates'
    | 'givesWebp'
    | 'comicPieces'
    | 'comicFiles'
    | 'stripPages'
    | 'shotFile'
  >;
}) {
  const comics = createComics({ store, engine, movingPictures: animatics.movingPictures });

  return make;

  async function make(
    { pages, format, inside = 'png', quality = USUAL_QUALITY, print = NO_PRINT, film, strip, living = false }: Wish,
    how: Work,
    { carry, beside }: Cargo,
  ): Promise<Blob> {
    const documents = strip ? await stripped(pages, how) : pages;
    if (isList(format)) {
      const text = await engine.shotFile(format, shotList(), { signal: how.signal });
      return new Blob([text], { type: FORMATS[format].type });
    }
    if (film && isFilm(format)) return animatics.film({ ...film, kind: format }, how);
    if (format === 'pdf') return printed(documents, print, quality, how);
    if (isBook(format)) return comics.book(format, documents, quality, how, living);
    if (!isArchive(format)) return picture(documents[0], format as 'png' | 'jpeg' | 'webp', quality, how, carry);
    const pictures = await drawnPages(documents, how, (document, page) =>
      picture(document, inside, quality, page, async (png) => png),
    );
    const entries = pictures.map((blob, i) => ({ name: pageName(i, pictures.length, inside), blob }));
    if (format === 'cbz') entries.push(...(await comics.about(documents, inside, how)));
    const project = await beside(how);
    if (project) entries.push(project);
    return new Blob([await archiveOf(entries, { signal: how.signal })], { type: FORMATS[format].type });
  }

  /** The pages of a strip. Their text avoids the subjects of the photos. */
  function stripped(pages: readonly PageDocument[], { signal }: Work) {
    const facts = [...store.album.peek().values()];
    const photos = facts.flatMap(({ id, meta }) =>
      meta ? [[id, { taken: meta.taken, subjects: meta.subjects }] as const] : [],
    );
    return engine.stripPages({ pages, photos: Object.fromEntries(photos) }, { signal });
  }

  /** A PDF file; of plates one each, in an archive. */
  async function printed(documents: readonly PageDocument[], print: Print, quality: number, how: Work) {
    const title = store.project.peek().name || strings.name;
    const album = store.album.peek();
    const alts = documents.map((document) =>
      document.panels.map(({ plain }, i) =>
        plain
          ? strings.boards.logo
          : strings.panelHolds({ n: i + 1, what: describePanel(document, album, i) || strings.somePhoto }),
      ),
    );
    const wish = { ...how, quality, title, alts, options: { language: currentLanguage(), ...pdfOptions(print) } };
    const pages = documents.map((document) => bled(document, print.bleed));
    if (!print.plates) return engine.exportPdf(pages, wish);
    const plates = await engine.exportPlates(pages, wish);
    const entries = plates.map(({ ink, blob }, i) => ({
      name: `${i + 1}-${inkName(ink)}.${FORMATS.pdf.ending}`,
      blob,
    }));
    return new Blob([await archiveOf(entries)], { type: FORMATS.zip.type });
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
    return carry(await engine.exportPng(document, how), kept(document), how);
  }
}

/** The name of an ink in the language of this visit. */
function inkName(ink: string) {
  return (strings.print.inks as Record<string, string>)[ink] ?? ink;
}
