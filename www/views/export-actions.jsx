// @ts-check
import { FORMATS } from '../state/formats.js';
import { strings } from '../strings.js';
import { useApp } from './context.js';
import { Icon } from './icon.jsx';

/**
 * What can be done with the pages: the copy is always a PNG of this page.
 * @param {{ wish: import('../state/page-making.js').Wish, page: import('../engine/documents.js').PageDocument | null, close: () => void }} props
 */
export function ExportActions({ wish, page, close }) {
  const { download } = useApp();
  const off = wish.pages.length === 0 || download.progress.value !== null;
  const act = (/** @type {() => Promise<void>} */ run) => () => {
    void run();
    close();
  };
  return (
    <div class="export-actions">
      <button type="button" class="button strong wide" disabled={off} onClick={act(() => download.saveAs(wish))}>
        <Icon name="download" />{strings.save}
      </button>
      {page && canCopy() && (
        <button type="button" class="button" disabled={off} onClick={act(() => download.copy(page))}>
          <Icon name="duplicate" />{strings.copyPage}
        </button>
      )}
      {canShare(wish.format) && (
        <button type="button" class="button" disabled={off} onClick={act(() => download.share(wish))}>
          <Icon name="export" />{strings.shareFile}
        </button>
      )}
    </div>
  );
}

function canCopy() {
  return typeof ClipboardItem === 'function' && typeof navigator.clipboard?.write === 'function';
}

/** @param {import('../state/formats.js').Format} format */
function canShare(format) {
  const { ending, type } = FORMATS[format];
  try {
    return navigator.canShare?.({ files: [new File(['x'], `page.${ending}`, { type })] }) ?? false;
  } catch {
    return false;
  }
}
