/**
 * The ways out: pages shown as they will be, in another size or with fewer pixels, then saved as one of many kinds of
 * file, copied or shared.
 */

import { useEffect, useMemo, useState } from 'preact/hooks';
import { FORMATS, OF_MANY, OF_ONE, isArchive } from './formats.ts';
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
import type { PageDocument } from '../engine/types.ts';
import type { Format, Inside } from './formats.ts';

const PREVIEW = 220;

export function ExportDialog() {
  const { store, download, engine, ui } = useApp();
  const page = store.page.value as PageDocument;
  const count = download.sheets().length;
  const [every, setEvery] = useState(false);
  const all = every && count > 1;
  const [size, setSize] = useState(sizeId(page.page));
  const [factor, setFactor] = useState(1);
  const [one, setOne] = useState('png' as Format);
  const [many, setMany] = useState('pdf' as Format);
  const [inside, setInside] = useState('png' as Inside);
  const [quality, setQuality] = useState(USUAL_QUALITY);
  const base = all ? page.page : (PAGE_SIZES.find(({ id }) => id === size) ?? page.page);
  const { width, height, dpi } = scaled(base, factor);
  const document = useMemo(() => download.preview({ width, height, dpi }), [page, width, height, dpi]);
  const sheets = useMemo(
    () => (all ? download.scaledSheets(factor) : document ? [document] : []),
    [all, factor, document],
  );
  const format = all ? many : one;
  const webpHasQuality = useWebpQuality();
  const made = isArchive(format) ? inside : format;
  const lossy = made === 'webp' ? webpHasQuality : FORMATS[made].lossy;
  const wish = useMemo(() => ({ pages: sheets, format, inside, quality }), [sheets, format, inside, quality]);
  const close = () => {
    ui.dialog.value = null;
  };
  const drawnWidth = screenPixels(PREVIEW * Math.min(1, width / height));

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
          <FormatChoice
            formats={all ? OF_MANY : OF_ONE}
            format={format}
            choose={all ? setMany : setOne}
            inside={inside}
            chooseInside={setInside}
          />
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
          <p class="quiet export-facts">
            <span>{strings.pixels(width, height)}</span>
            <FileSize wish={wish} />
          </p>
          {made === 'png' && <ExportProject />}
          <ExportActions wish={wish} page={document} close={close} />
        </div>
      </div>
    </Dialog>
  );
}

function Sizes({ size, choose }: { size: string; choose: (id: string) => void }) {
  return (
    <fieldset class="sizes">
      <legend>{strings.pageSize}</legend>
      {PAGE_SIZES.map((option) => (
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
