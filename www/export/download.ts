/**
 * Exports: pages as files, to the clipboard or to the share sheet, and single panels. They are rendered at print size
 * in the background, with progress, one at a time.
 */

import { signal } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import { save } from '../ui/files.ts';
import { fileName, panelName } from './export-name.ts';
import { FORMATS, isArchive, isFilm, isList } from './formats.ts';
import { createMaking } from './page-making.ts';
import { createTimeLeft } from './time-left.ts';
import { sized } from '../page/paper.ts';
import { codeOf, explain } from '../ui/explain.ts';
import type { Animatics, AnimaticWish } from '../motion/animatics.ts';
import type { Messages } from '../ui/messages.ts';
import type { Pages } from '../document/pages.ts';
import type { Progress, Store } from '../document/store.ts';
import type { PageDocument, PageSettings, ShotList } from '../engine/types.ts';
import type { Engine } from '../engine/engine.ts';
import type { PageFiles } from '../storage/files/page-files.ts';
import type { Cargo, Wish, Work } from './page-making.ts';
import type { Signal } from '@preact/signals';
import type { Format } from './formats.ts';

export type Download = ReturnType<typeof createDownload>;

export function createDownload({
  store,
  pages,
  engine,
  messages,
  pageFiles,
  shotList,
  animatics,
  onSaved = () => {},
}: {
  store: Store;
  pages: Pages;
  messages: Messages;
  engine: Pick<
    Engine,
    | 'exportPng'
    | 'exportJpeg'
    | 'exportWebp'
    | 'exportPdf'
    | 'exportPlates'
    | 'exportPanel'
    | 'exportSubject'
    | 'givesWebp'
    | 'comicPieces'
    | 'comicFiles'
    | 'stripPages'
    | 'shotFile'
  >;
  pageFiles: Pick<PageFiles, 'take' | 'carrying' | 'packed'>;
  shotList: () => ShotList;
  animatics: Pick<Animatics, 'film' | 'movingPictures'>;
  onSaved?: (pages: readonly PageDocument[]) => void;
}) {
  /** `packing`: the pages are drawn, and other content is added. `filming`: progress counts frames. `left`: seconds. */
  const progress: Signal<
    (Progress & { packing?: boolean; filming?: AnimaticWish['of']; left?: number | null }) | null
  > = signal(null);
  let running: AbortController | null = null;
  const make = createMaking({ store, engine, shotList, animatics });

  return { progress, start, saveAs, copy, share, savePanel, saveSubject, cancel, preview, sheets, scaledSheets };

  /** @returns the pages of the storyboard, in their order */
  function sheets(): readonly PageDocument[] {
    return store.sheets.value;
  }

  /** All pages, with their pixel size multiplied by `factor`. */
  function scaledSheets(factor: number): PageDocument[] {
    const by = (length: number) => Math.round(length * factor);
    return sheets().map((document) => {
      const { width, height, dpi } = document.page;
      return { ...document, page: sized(document.page, { width: by(width), height: by(height), dpi: by(dpi) }) };
    });
  }

  /** The page at another size: the same photos and layout, with new crops. */
  function preview(size: Partial<PageSettings>): PageDocument | null {
    const page = store.page.peek();
    const settings = page && sized(page.page, size);
    if (!page || !settings) return null;
    const same = settings.width === page.page.width && settings.height === page.page.height;
    return same
      ? page
      : pages.plan({ keep: { layout: true, style: true, photos: true }, page: settings, seed: page.seed });
  }

  /** @param page default: the current page */
  async function start(page: PageDocument | null = store.page.peek()) {
    if (page) await saveAs({ pages: [page], format: 'png' });
  }

  async function saveAs(wish: Wish) {
    const cargo = loaded(wish);
    const file = await work(
      (how) => make(wish, how, cargo),
      strings.exportFailed,
      isFilm(wish.format) ? wish.film?.of : undefined,
    );
    if (!file) return;
    const [name, count] = [nameOf(wish), wish.pages.length];
    save(file, name);
    onSaved(wish.pages);
    const isOfPages = count > 1 && !isFilm(wish.format) && !isList(wish.format);
    const saved = isOfPages ? strings.pagesSaved({ name, count }) : strings.fileSaved({ name });
    messages.note(cargo.unclean > 0 ? `${saved} ${strings.photosUnclean({ n: cargo.unclean })}` : saved);
  }

  function nameOf(wish: Wish) {
    return fileName(store.project.peek(), wish.pages.length, fileFormat(wish), wish.print !== undefined);
  }

  /** The project data in the exported file. `unclean`: photos whose metadata cannot be removed. */
  function loaded({ format }: Wish) {
    // Read before any wait, because the user's choice applies to this file.
    const what = isArchive(format) || format === 'png' ? pageFiles.take() : 'none';
    const packing = ({ signal: stop }: Work): Work => ({
      signal: stop,
      onProgress: (done, total) => {
        if (what === 'photos') progress.value = { done, total, packing: true };
      },
    });
    const goods = {
      unclean: 0,
      carry: async (png, page, how) => {
        const carrying = await pageFiles.carrying(png, page, what, packing(how));
        goods.unclean += carrying.unclean;
        return carrying.png;
      },
      beside: async (how) => {
        const packed = await pageFiles.packed(what, packing(how));
        goods.unclean += packed?.unclean ?? 0;
        return packed?.entry ?? null;
      },
    } as Cargo & { unclean: number };
    return goods;
  }

  /** @param index of a panel of the page */
  async function savePanel(index: number) {
    const page = store.page.peek();
    const file = page && (await work((how) => engine.exportPanel(page, index, how), strings.exportFailed));
    if (!file) return;
    saveAndSay(file, panelName(store.project.peek(), index));
  }

  /** @param id of a photo whose subject is known */
  async function saveSubject(id: string) {
    const { name } = store.album.peek().get(id) ?? {};
    const mask = store.masks.peek().get(id);
    if (!mask) return;
    const file = await work((how) => engine.exportSubject(id, mask, how), strings.exportFailed);
    if (!file) return;
    saveAndSay(file, `${(name ?? id).replace(/\.[^.]+$/, '')}-subject.png`);
  }

  function saveAndSay(file: Blob, name: string) {
    save(file, name);
    messages.note(strings.fileSaved({ name }));
  }

  /** The browser is handed the promise of a picture, as some allow the clipboard only in the moment of the click. */
  async function copy(page: PageDocument) {
    const png = work((how) => engine.exportPng(page, how), strings.exportFailed);
    const promised = png.then((file) => file ?? Promise.reject(new DOMException('', 'AbortError')));
    try {
      await navigator.clipboard.write([new ClipboardItem({ 'image/png': promised })]);
      messages.note(strings.copied);
    } catch (error) {
      // The error of the picture itself is already reported.
      if (await png) messages.alert(strings.copyFailed({ why: explain(error) }));
    }
  }

  async function share(wish: Wish) {
    const goods = loaded(wish);
    const made = await work(
      (how) => make(wish, how, goods),
      strings.exportFailed,
      isFilm(wish.format) ? wish.film?.of : undefined,
    );
    if (made) await hand(new File([made], nameOf(wish), { type: FORMATS[fileFormat(wish)].type }));
  }

  async function hand(file: File) {
    try {
      await navigator.share({ files: [file] });
    } catch (error) {
      const { name } = error as Error;
      // Drawing took too long after the click, so the browser requires another click.
      if (name === 'NotAllowedError')
        messages.note(strings.readyToShare, { label: strings.sharePart, run: () => void hand(file) });
      else if (name !== 'AbortError') messages.alert(strings.shareFailed({ why: explain(error) }));
    }
  }

  /**
   * Runs one task at a time, with progress. Errors are reported.
   * @returns null if the task was cancelled or failed
   */
  async function work(
    make: (how: Work) => Promise<Blob>,
    failed: typeof strings.exportFailed,
    filming?: AnimaticWish['of'],
  ): Promise<Blob | null> {
    if (running) return null;
    running = new AbortController();
    const { signal: stop } = running;
    const leftOf = createTimeLeft(() => performance.now());
    try {
      const made = await make({
        signal: stop,
        onProgress: (done, total) => {
          progress.value = { done, total, filming, left: leftOf(done, total) };
        },
      });
      return stop.aborted ? null : made;
    } catch (error) {
      const { photo } = error as { photo?: string };
      // In other places, this code is about a file that is read.
      const reason = explain(error, { reasons: { 'worker-lost': strings.exportLost } });
      const why = photo ? strings.fileFailed({ name: photo, why: reason }) : reason;
      if (codeOf(error) !== 'cancelled') messages.alert(failed({ why }));
      return null;
    } finally {
      running = null;
      progress.value = null;
    }
  }

  function cancel() {
    running?.abort();
  }
}

/** The kind of file that is saved: plates of inks are files in an archive. */
function fileFormat({ format, print }: Wish): Format {
  return format === 'pdf' && print?.plates ? 'zip' : format;
}
