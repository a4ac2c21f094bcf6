import { FORMATS } from './formats.ts';
import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { useApp } from '../ui/context.ts';
import type { PageDocument } from '../engine/types.ts';
import type { Format } from './formats.ts';
import type { Wish } from './page-making.ts';

/** Actions of the export dialog. Copying always uses a PNG of this page. */
export function ExportActions({ wish, page, close }: { wish: Wish; page: PageDocument | null; close: () => void }) {
  const { download } = useApp();
  const ready = {
    enabled: wish.pages.length > 0,
    why: download.progress.value === null ? '' : strings.exportRuns,
  };
  const act = (run: () => Promise<void>) => () => {
    void run();
    close();
  };
  const save = { ...ready, label: strings.save, icon: 'download', run: act(() => download.saveAs(wish)) };
  const copy = page && { ...ready, label: strings.copyPage, icon: 'duplicate', run: act(() => download.copy(page)) };
  const share = { ...ready, label: strings.shareFile, icon: 'export', run: act(() => download.share(wish)) };
  return (
    <div class="export-actions">
      <ActionButton action={save} class="button strong wide" text />
      {copy && canCopy() && <ActionButton action={copy} class="button" text />}
      {canShare(wish.format) && <ActionButton action={share} class="button" text />}
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
