import { FORMATS } from './formats.ts';
import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { Icon } from '../ui/icon.tsx';
import type { PageDocument } from '../engine/types.ts';
import type { Format } from './formats.ts';
import type { Wish } from './page-making.ts';

/** Actions of the export dialog. Copying always uses a PNG of this page. */
export function ExportActions({ wish, page, close }: { wish: Wish; page: PageDocument | null; close: () => void }) {
  const { download } = useApp();
  const off = wish.pages.length === 0 || download.progress.value !== null;
  const act = (run: () => Promise<void>) => () => {
    void run();
    close();
  };
  return (
    <div class="export-actions">
      <button type="button" class="button strong wide" disabled={off} onClick={act(() => download.saveAs(wish))}>
        <Icon name="download" />
        {strings.save}
      </button>
      {page && canCopy() && (
        <button type="button" class="button" disabled={off} onClick={act(() => download.copy(page))}>
          <Icon name="duplicate" />
          {strings.copyPage}
        </button>
      )}
      {canShare(wish.format) && (
        <button type="button" class="button" disabled={off} onClick={act(() => download.share(wish))}>
          <Icon name="export" />
          {strings.shareFile}
        </button>
      )}
    </div>
  );
}

function canCopy() {
  return typeof ClipboardItem === 'function' && typeof navigator.clipboard?.write === 'function';
}

function canShare(format: Format) {
  const { ending, type } = FORMATS[format];
  try {
    return navigator.canShare?.({ files: [new File(['x'], `page.${ending}`, { type })] }) ?? false;
  } catch {
    return false;
  }
}
