// @ts-check
/**
 * The page in another size or with fewer pixels: shown as it will be, then saved.
 */

import { useMemo, useState } from 'preact/hooks';
import { PAGE_SIZES, scaled, sizeId } from '../state/paper.js';
import { strings } from '../strings.js';
import { Bitmap, screenPixels } from './bitmap.jsx';
import { useApp } from './context.js';
import { Dialog } from './dialog.jsx';
import { ExportProject } from './export-project.jsx';
import { Icon } from './icon.jsx';

const PREVIEW = 220;

export function ExportDialog() {
  const { store, download, engine, ui } = useApp();
  const page = /** @type {import('../engine/documents.js').PageDocument} */ (store.page.value);
  const [size, setSize] = useState(sizeId(page.page));
  const [factor, setFactor] = useState(1);
  const base = PAGE_SIZES.find(({ id }) => id === size) ?? page.page;
  const { width, height, dpi } = scaled(base, factor);
  const document = useMemo(() => download.preview({ width, height, dpi }), [page, width, height, dpi]);
  const close = () => { ui.dialog.value = null; };
  const drawnWidth = screenPixels(PREVIEW * Math.min(1, width / height));

  function save() {
    close();
    download.start(document);
  }

  return (
    <Dialog title={strings.exportPage} class="export-dialog" onClose={close}>
      <div class="export">
        <div class="export-preview">
          <div class="export-sheet" style={{ '--aspect': width / height }}>
            {document && <Bitmap of={`${size}`} draw={(call) => engine.renderPage(document, drawnWidth, call)} />}
          </div>
        </div>
        <div class="export-choices">
          <fieldset class="sizes">
            <legend>{strings.pageSize}</legend>
            {PAGE_SIZES.map((option) => (
              <label class="size" key={option.id}>
                <input type="radio" name="size" value={option.id} checked={size === option.id} onChange={() => setSize(option.id)} />
                <SizePicture width={option.width} height={option.height} />
                <span>{strings.size[/** @type {'a4'} */ (option.id)]}</span>
              </label>
            ))}
          </fieldset>
          <label class="field">
            <span>{strings.resolution}</span>
            <select class="select" value={factor} onChange={(event) => setFactor(Number(event.currentTarget.value))}>
              <option value={1}>{strings.full(base.dpi)}</option>
              <option value={0.5}>{strings.half}</option>
            </select>
          </label>
          <label class="field">
            <span>{strings.format}</span>
            <select class="select"><option>{strings.png}</option></select>
          </label>
          <p class="quiet">{strings.pixels(width, height)}</p>
          <ExportProject />
          <button type="button" class="button strong wide" disabled={!document || download.progress.value !== null} onClick={save}>
            <Icon name="download" />{strings.save}
          </button>
        </div>
      </div>
    </Dialog>
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
