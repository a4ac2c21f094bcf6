/**
 * The ways out: pages shown as they will be, in another size or with fewer pixels, then saved as one of many kinds of
 * file, copied or shared.
 */

import { useEffect, useMemo, useState } from 'preact/hooks';
import { FORMATS, isArchive, isList, OF_MANY, OF_ONE, pictureIn } from './formats.ts';
import { USUAL_QUALITY } from './page-making.ts';
import { PAGE_SIZES, scaled, sizeId } from '../page/paper.ts';
import { strings } from '../strings/strings.ts';
import { Bitmap, screenPixels } from '../ui/bitmap.tsx';
import { useApp } from '../ui/context.ts';
import { Dialog } from '../ui/dialog.tsx';
import { ExportActions } from './export-actions.tsx';
import { ExportProject } from './export-project.tsx';
import { FileSize } from './file-size.tsx';
import { FormatChoice } from './format-choice.tsx';
import { enlarged, hasPlates, NO_PRINT } from './print.ts';
import { LazyAnimatic } from '../motion/lazy-animatic.tsx';
import { LivingChoice } from '../motion/living-choice.tsx';
import { PrintCheck } from './print-check.tsx';
import { PrintOptions } from './print-options.tsx';
import type { PageDocument } from '../engine/types.ts';
import type { Format, Inside, Way } from './formats.ts';
import type { Print } from './print.ts';

const PREVIEW = 220;
/** Sizes of fewer dots an inch are for screens. */
const COARSE_FROM = 150;
/** Sizes of where A4 is not what lies in a printer. */
const AMERICAN = /letter|legal|tabloid|^us-/;
/** The sizes with a picture, in their order; the others are in a list. */
const PICTURED: readonly string[] = ['a4', 'a4-landscape', 'letter', 'square', 'wide', 'story', 'portrait', 'webtoon'];

export function ExportDialog() {
  const { store, download, engine, book, ui } = useApp();
  const page = store.page.value as PageDocument;
  const count = download.sheets().length;
  const [every, setEvery] = useState(false);
  const all = every && count > 1;
  const [size, setSize] = useState(sizeId(page.page));
  const [factor, setFactor] = useState(1);
  const [one, setOne] = useState(ui.exportWay.peek() ?? ('png' as Way));
  const [many, setMany] = useState('pdf' as Way);
  const [inside, setInside] = useState('png' as Inside);
  const [quality, setQuality] = useState(USUAL_QUALITY);
  const [print, setPrint] = useState(NO_PRINT);
  const [enlarge, setEnlarge] = useState(false);
  const [living, setLiving] = useState(true);
  const base = all ? page.page : (PAGE_SIZES.find(({ id }) => id === size) ?? page.page);
  const { width, height, dpi } = scaled(base, factor);
  const document = useMemo(() => download.preview({ width, height, dpi }), [page, width, height, dpi]);
  const sheets = useMemo(
    () => (all ? download.scaledSheets(factor) : document ? [document] : []),
    [all, factor, document],
  );
  const way = all ? many : one;
  // A film has choices of its own, and what is below is not looked at.
  const filmed = way === 'animatic' ? 'shots' : way === 'motion' ? 'pages' : null;
  const format = filmed ? 'png' : (way as Format);
  const webpHasQuality = useWebpQuality();
  const made = pictureIn(format, inside, webpHasQuality);
  const lossy = made === 'webp' ? webpHasQuality : FORMATS[made].lossy;
  const plates = format === 'pdf' && hasPlates(sheets, store.styles.value);
  const asked = useMemo(
    () => ({ ...print, plates: print.plates && plates, sheets: sheets.length > 1 ? print.sheets : 'none' }) as Print,
    [print, plates, sheets],
  );
  const wish = useMemo(
    () => ({ pages: enlarged(sheets, enlarge && dpi >= COARSE_FROM), format, inside, quality, print: asked, living }),
    [sheets, enlarge, dpi, format, inside, quality, asked, living],
  );
  const close = () => {
    // It tells that it was closed a moment later: another may be open by then.
    if (ui.dialog.peek() === 'export') ui.dialog.value = null;
    ui.exportWay.value = null;
  };
  const drawnWidth = screenPixels(PREVIEW * Math.min(1, width / height));

  const formatChoice = (
    <FormatChoice
      formats={all ? OF_MANY : OF_ONE}
      format={way}
      choose={all ? setMany : setOne}
      inside={inside}
      chooseInside={setInside}
    />
  );
  if (filmed)
    return (
      <Dialog title={strings.exportPage} class="export-dialog" onClose={close}>
        <LazyAnimatic of={filmed} close={close}>
          {formatChoice}
        </LazyAnimatic>
      </Dialog>
    );
  return (
    <Dialog title={strings.exportPage} class="export-dialog" onClose={close}>
      <div class="export">
        <div class="export-preview">
          <div class="export-sheet" style={{ '--aspect': width / height }}>
            {document && <Bitmap of={`${size}`} draw={(call) => engine.renderPage(document, drawnWidth, call)} />}
          </div>
        </div>
        <div class="export-choices">
          {count > 1 && (
            <fieldset class="export-pages">
              <legend>{strings.whichPages}</legend>
              <label class="choice">
                <input type="radio" name="pages" checked={!all} onChange={() => setEvery(false)} />
                {strings.thisPage}
              </label>
              <label class="choice">
                <input type="radio" name="pages" checked={all} onChange={() => setEvery(true)} />
                {strings.allPages(count)}
              </label>
            </fieldset>
          )}
          {!all && <Sizes size={size} choose={setSize} />}
          <label class="field">
            <span>{strings.resolution}</span>
            <select class="select" value={factor} onChange={(event) => setFactor(Number(event.currentTarget.value))}>
              <option value={1}>{strings.full(base.dpi)}</option>
              <option value={0.5}>{strings.half}</option>
            </select>
          </label>
          {dpi >= COARSE_FROM && (
            <PrintCheck
              pages={sheets}
              only={all ? null : book.at.value}
              enlarge={enlarge}
              change={setEnlarge}
              close={close}
            />
          )}
          {formatChoice}
          {format === 'pdf' && (
            <PrintOptions
              print={print}
              change={(part) => setPrint({ ...print, ...part })}
              pages={sheets.length}
              plates={plates}
              home={AMERICAN.test(sizeId(page.page)) ? 'letter' : 'a4'}
            />
          )}
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
              <output aria-hidden="true">{quality}</output>
            </label>
          )}
          {isList(format) ? (
            <p class="quiet">{strings.boards.listHelp}</p>
          ) : (
            <p class="quiet export-facts">
              <span>{strings.pixels(width, height)}</span>
              <FileSize wish={wish} />
            </p>
          )}
          {(format === 'png' || isArchive(format)) && <ExportProject archive={isArchive(format)} />}
          <ExportActions wish={wish} page={document} close={close} />
        </div>
      </div>
    </Dialog>
  );
}

function Sizes({ size, choose }: { size: string; choose: (id: string) => void }) {
  const pictured = PAGE_SIZES.filter(({ id }) => PICTURED.includes(id) || id === size);
  const listed = PAGE_SIZES.filter(({ id }) => !PICTURED.includes(id));
  return (
    <fieldset class="sizes">
      <legend>{strings.pageSize}</legend>
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
