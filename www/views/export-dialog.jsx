// @ts-check
/**
 * The ways out: pages shown as they will be, in another size or with fewer pixels, then saved as one of many kinds of
 * file, copied or shared.
 */

import { useMemo, useState } from 'preact/hooks';
import { FORMATS, OF_MANY, OF_ONE, isArchive } from '../state/formats.js';
import { USUAL_QUALITY } from '../state/page-making.js';
import { PAGE_SIZES, scaled, sizeId } from '../state/paper.js';
import { strings } from '../strings.js';
import { Bitmap, screenPixels } from './bitmap.jsx';
import { useApp } from './context.js';
import { Dialog } from './dialog.jsx';
import { ExportActions } from './export-actions.jsx';
import { ExportProject } from './export-project.jsx';
import { FileSize } from './file-size.jsx';
import { FormatChoice } from './format-choice.jsx';

/** @typedef {import('../state/formats.js').Format} Format */
/** @typedef {import('../state/formats.js').Inside} Inside */

const PREVIEW = 220;

export function ExportDialog() {
  const { store, download, engine, ui } = useApp();
  const page = /** @type {import('../engine/documents.js').PageDocument} */ (store.page.value);
  const count = download.sheets().length;
  const [every, setEvery] = useState(false);
  const all = every && count > 1;
  const [size, setSize] = useState(sizeId(page.page));
  const [factor, setFactor] = useState(1);
  const [one, setOne] = useState(/** @type {Format} */ ('png'));
  const [many, setMany] = useState(/** @type {Format} */ ('pdf'));
  const [inside, setInside] = useState(/** @type {Inside} */ ('png'));
  const [quality, setQuality] = useState(USUAL_QUALITY);
  const base = all ? page.page : PAGE_SIZES.find(({ id }) => id === size) ?? page.page;
  const { width, height, dpi } = scaled(base, factor);
  const document = useMemo(() => download.preview({ width, height, dpi }), [page, width, height, dpi]);
  const sheets = useMemo(() => (all ? download.scaledSheets(factor) : document ? [document] : []), [all, factor, document]);
  const format = all ? many : one;
  const lossy = isArchive(format) ? FORMATS[inside].lossy : FORMATS[format].lossy;
  const wish = useMemo(() => ({ pages: sheets, format, inside, quality }), [sheets, format, inside, quality]);
  const close = () => { ui.dialog.value = null; };
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
              <label class="choice"><input type="radio" name="pages" checked={!all} onChange={() => setEvery(false)} />{strings.thisPage}</label>
              <label class="choice"><input type="radio" name="pages" checked={all} onChange={() => setEvery(true)} />{strings.allPages(count)}</label>
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
          <FormatChoice formats={all ? OF_MANY : OF_ONE} format={format} choose={all ? setMany : setOne} inside={inside} chooseInside={setInside} />
          {lossy && (
            <label class="field">
              <span>{strings.pictureQuality}</span>
              <input type="range" min="30" max="100" value={quality} onInput={(event) => setQuality(Number(event.currentTarget.value))} />
              <output aria-hidden="true">{quality}</output>
            </label>
          )}
          <p class="quiet export-facts"><span>{strings.pixels(width, height)}</span><FileSize wish={wish} /></p>
          {(isArchive(format) ? inside : format) === 'png' && <ExportProject />}
          <ExportActions wish={wish} page={document} close={close} />
        </div>
      </div>
    </Dialog>
  );
}

/** @param {{ size: string, choose: (id: string) => void }} props */
function Sizes({ size, choose }) {
  return (
    <fieldset class="sizes">
      <legend>{strings.pageSize}</legend>
      {PAGE_SIZES.map((option) => (
        <label class="size" key={option.id}>
          <input type="radio" name="size" value={option.id} checked={size === option.id} onChange={() => choose(option.id)} />
          <SizePicture width={option.width} height={option.height} />
          <span>{strings.size[/** @type {'a4'} */ (option.id)]}</span>
        </label>
      ))}
    </fieldset>
  );
}

/** @param {{ width: number, height: number }} props */
function SizePicture({ width, height }) {
  const scale = 30 / Math.max(width, height);
  const w = width * scale;
  const h = height * scale;
  return (
    <svg class="size-picture" viewBox="0 0 34 34" aria-hidden="true">
      <rect x={17 - w / 2} y={17 - h / 2} width={w} height={h} rx="1.5" />
    </svg>
  );
}
