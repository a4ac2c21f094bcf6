/** The export dialog: the format first, then its settings next to a preview of the page. */

import { useEffect, useMemo, useState } from 'preact/hooks';
import { hasAll, madeOf, shownChoice, wayOf, withAll } from './export-choice.ts';
import { FORMATS, isArchive, isBoard, isList, pictureIn } from './formats.ts';
import { USUAL_QUALITY } from './page-making.ts';
import { PAGE_SIZES, scaled, sizeId } from '../page/paper.ts';
import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { Bitmap } from '../ui/bitmap.tsx';
import { useApp } from '../ui/context.ts';
import { Dialog } from '../ui/dialog.tsx';
import { explain } from '../ui/explain.ts';
import { Icon } from '../ui/icon.tsx';
import { ExportActions } from './export-actions.tsx';
import { ExportProject } from './export-project.tsx';
import { FileSize } from './file-size.tsx';
import { FormatChoice, KindChoice } from './format-choice.tsx';
import { enlarged, hasPlates, USUAL_PRINT } from './print.ts';
import { LazyAnimatic } from '../motion/lazy-animatic.tsx';
import { LivingChoice } from '../motion/living-choice.tsx';
import { PrintCheck } from './print-check.tsx';
import { CleanChoice } from '../storage/clean-choice.tsx';
import { PrintOptions } from './print-options.tsx';
import type { PageDocument } from '../engine/types.ts';
import type { Format } from './formats.ts';
import type { Print } from './print.ts';

/** The longer side of the drawn preview, in pixels. It is larger than on the screen, because scaling smooths dots of styles. */
const PREVIEW = 920;
/** Lower resolutions, in DPI, are for screens. */
const COARSE_FROM = 150;
/** Formats of one picture, which the clipboard can hold. */
const PICTURES: readonly Format[] = ['png', 'jpeg', 'webp'];
/** Page sizes of countries that print on letter paper. */
const AMERICAN = /letter|legal|tabloid|^us-/;
/** The sizes with a picture, in their order; the others are in a list. */
const PICTURED: readonly string[] = ['a4', 'a4-landscape', 'letter', 'square', 'wide', 'story', 'portrait', 'webtoon'];

export function ExportDialog() {
  const { store, download, engine, book, boards, messages, ui, exportChoice, keeping } = useApp();
  const page = store.page.value as PageDocument;
  const count = download.sheets().length;
  const choice = shownChoice(exportChoice, book.isMade.value);
  const { choose } = exportChoice;
  const all = hasAll(choice) && count > 1;
  const [size, setSize] = useState(sizeId(page.page));
  const [factor, setFactor] = useState(1);
  const [quality, setQuality] = useState(USUAL_QUALITY);
  const [print, setPrint] = useState(USUAL_PRINT);
  const [enlarge, setEnlarge] = useState(false);
  const [living, setLiving] = useState(true);
  const base = all ? page.page : (PAGE_SIZES.find(({ id }) => id === size) ?? page.page);
  const { width, height, dpi } = scaled(base, factor);
  const way = wayOf(choice);
  const onBoard = isBoard(way);
  const [boardSheets, setBoardSheets] = useState([] as readonly PageDocument[]);
  useEffect(() => {
    if (!onBoard) return;
    boards.sheets().then(setBoardSheets, (error) => {
      messages.alert(strings.boards.noSheets({ why: explain(error) }));
    });
  }, [onBoard]);
  const planned = useMemo(() => download.preview({ width, height, dpi }), [page, width, height, dpi]);
  const document = onBoard ? (boardSheets[0] ?? null) : planned;
  const sheets = useMemo(
    () => (onBoard ? boardSheets : all ? download.scaledSheets(factor) : document ? [document] : []),
    [onBoard, boardSheets, all, factor, document],
  );
  // A video has a player and settings instead of the choices below.
  const filmed = way === 'animatic' ? 'shots' : way === 'motion' ? 'pages' : null;
  const { format, inside } = madeOf(way, all, choice.inside);
  const webpHasQuality = useWebpQuality();
  const made = pictureIn(format, inside, webpHasQuality);
  const lossy = made === 'webp' ? webpHasQuality : FORMATS[made].lossy;
  const printed = way === 'print';
  const plates = printed && hasPlates(sheets, store.styles.value);
  const onPaper = useMemo(
    (): Print | undefined =>
      printed
        ? { ...print, plates: print.plates && plates, sheets: sheets.length > 1 ? print.sheets : 'none' }
        : undefined,
    [printed, print, plates, sheets],
  );
  const wish = useMemo(
    () => ({
      pages: enlarged(sheets, printed && enlarge && dpi >= COARSE_FROM),
      format,
      inside,
      quality,
      print: onPaper,
      strip: way === 'strip',
      living,
    }),
    [way, sheets, printed, enlarge, dpi, format, inside, quality, onPaper, living],
  );
  const isWhole = all || onBoard || way === 'project' || filmed !== null || isList(format);
  const named = (isWhole ? download.sheets() : [page]).some(({ words }) => words?.some(({ located }) => located));
  const close = () => {
    // It tells that it was closed a moment later: another may be open by then.
    if (ui.dialog.peek() === 'export') ui.dialog.value = null;
    exportChoice.asked.value = null;
  };
  const aspect = document ? document.page.width / document.page.height : width / height;
  const drawnWidth = Math.round(PREVIEW * Math.min(1, aspect));
  const saveProject = {
    label: strings.save,
    icon: 'download',
    run() {
      void keeping.files.save();
      close();
    },
  };

  return (
    <Dialog title={strings.exportPage} class="export-dialog" onClose={close}>
      <KindChoice choice={choice} choose={choose} board={ui.work.value === 'boards' && boards.rows.value.length > 0} />
      {named && (
        <p class="export-places" role="note">
          <Icon name="alert" />
          {strings.exportPlaces}
        </p>
      )}
      {filmed ? (
        <LazyAnimatic of={filmed} close={close}>
          <FormatChoice choice={choice} choose={choose} />
        </LazyAnimatic>
      ) : (
        <div class="export">
          <div class="export-preview">
            <div class="export-sheet" style={{ '--aspect': aspect }}>
              {document && (
                <Bitmap of={onBoard ? document : size} draw={(call) => engine.renderPage(document, drawnWidth, call)} />
              )}
            </div>
          </div>
          <div class="export-choices">
            <FormatChoice choice={choice} choose={choose} />
            {way === 'project' ? (
              <>
                <CleanChoice />
                <p class="quiet">{strings.removeMetadataHelp}</p>
                <div class="export-actions">
                  <ActionButton action={saveProject} class="button strong wide" text />
                </div>
              </>
            ) : onBoard || isList(format) ? (
              <ExportActions wish={wish} page={null} close={close} />
            ) : (
              <>
                {count > 1 && (
                  <fieldset class="export-pages">
                    <legend>{strings.whichPages}</legend>
                    <label class="choice">
                      <input type="radio" name="pages" checked={!all} onChange={() => choose(withAll(choice, false))} />
                      {strings.thisPage}
                    </label>
                    <label class="choice">
                      <input type="radio" name="pages" checked={all} onChange={() => choose(withAll(choice, true))} />
                      {strings.allPages({ count })}
                    </label>
                  </fieldset>
                )}
                {format === 'zip' && way !== 'strip' && <p class="quiet">{strings.zipHelp}</p>}
                {printed && dpi >= COARSE_FROM && (
                  <PrintCheck
                    pages={sheets}
                    only={all ? null : book.at.value}
                    enlarge={enlarge}
                    change={setEnlarge}
                    close={close}
                  />
                )}
                {printed && (
                  <PrintOptions
                    print={print}
                    change={(part) => setPrint({ ...print, ...part })}
                    pages={sheets.length}
                    plates={plates}
                    home={AMERICAN.test(sizeId(page.page)) ? 'letter' : 'a4'}
                  />
                )}
                <label class="field">
                  <span>{strings.resolution}</span>
                  <select
                    class="select"
                    value={factor}
                    onChange={(event) => setFactor(Number(event.currentTarget.value))}
                  >
                    <option value={1}>
                      {base.dpi >= COARSE_FROM ? strings.fullDpi({ dpi: base.dpi }) : strings.full}
                    </option>
                    <option value={0.5}>
                      {base.dpi >= COARSE_FROM ? strings.halfDpi({ dpi: base.dpi / 2 }) : strings.half}
                    </option>
                  </select>
                </label>
                {format === 'html' && webpHasQuality && (
                  <LivingChoice of="pages" on={living} set={setLiving} note={strings.motion.larger} />
                )}
                {lossy && (
                  <label class="field">
                    <span>{strings.pictureQuality}</span>
                    <input
                      type="range"
                      min="30"
                      max="100"
                      value={quality}
                      onInput={(event) => setQuality(Number(event.currentTarget.value))}
                    />
                    <output aria-hidden="true">{strings.percent(quality / 100)}</output>
                  </label>
                )}
                {!all && <Sizes size={size} choose={setSize} />}
                {(format === 'png' || isArchive(format)) && <ExportProject archive={isArchive(format)} />}
                <p class="quiet export-facts">
                  <span>{strings.pixels({ w: width, h: height })}</span>
                  <FileSize wish={wish} />
                </p>
                <ExportActions wish={wish} page={PICTURES.includes(format) ? document : null} close={close} />
              </>
            )}
          </div>
        </div>
      )}
    </Dialog>
  );
}

function Sizes({ size, choose }: { size: string; choose: (id: string) => void }) {
  const pictured = PAGE_SIZES.filter(({ id }) => PICTURED.includes(id) || id === size);
  const listed = PAGE_SIZES.filter(({ id }) => !PICTURED.includes(id));
  // Another size changes the layout of the page, so this is rarely useful.
  return (
    <details class="export-size">
      <summary>
        {strings.pageSize}: {strings.size[size as 'a4'] ?? strings.thisPage}
      </summary>
      <fieldset class="sizes">
        <legend class="visually-hidden">{strings.pageSize}</legend>
        {pictured.map((option) => (
          <label class="size" key={option.id}>
            <input
              type="radio"
              name="size"
              value={option.id}
              checked={size === option.id}
              onChange={() => choose(option.id)}
            />
            <SizePicture width={option.width} height={option.height} />
            <span>{strings.size[option.id as 'a4']}</span>
          </label>
        ))}
        <select
          class="select more-sizes"
          aria-label={strings.print.moreSizes}
          value={listed.some(({ id }) => id === size) ? size : ''}
          onChange={(event) => event.currentTarget.value && choose(event.currentTarget.value)}
        >
          <option value="">{strings.print.moreSizes}</option>
          {listed.map(({ id }) => (
            <option key={id} value={id}>
              {strings.size[id]}
            </option>
          ))}
        </select>
      </fieldset>
    </details>
  );
}

function SizePicture({ width, height }: { width: number; height: number }) {
  const scale = 30 / Math.max(width, height);
  const w = width * scale;
  const h = height * scale;
  return (
    <svg class="size-picture" viewBox="0 0 34 34" aria-hidden="true">
      <rect x={17 - w / 2} y={17 - h / 2} width={w} height={h} rx="1.5" />
    </svg>
  );
}

/** Whether the browser encodes WebP, which then has a quality; ours has no loss. */
function useWebpQuality(): boolean {
  const { engine } = useApp();
  const [own, setOwn] = useState(true);
  useEffect(() => {
    engine.givesWebp().then(setOwn);
  }, []);
  return own;
}
