import { useEffect, useState } from 'preact/hooks';
import { estimated } from './estimate.ts';
import { isArchive, pictureIn } from './formats.ts';
import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { after } from '../engine/scheduler.ts';
import type { Wish } from './page-making.ts';

/** While a slider is dragged, nothing is measured. */
const REST_MS = 250;
/** Size of the two or three gray plates of a page, relative to the page in colour. */
const PLATES = 1.2;
/** Base64 text has four characters per three bytes. */
const AS_TEXT = 4 / 3;

/** The estimated file size, or nothing if it is unknown. */
export function FileSize({ wish }: { wish: Wish }) {
  const { engine, keeping } = useApp();
  const [bytes, setBytes] = useState(null as number | null);
  const [busy, setBusy] = useState(true);
  useEffect(() => {
    const stop = new AbortController();
    setBusy(true);
    const cancel = after(REST_MS, async () => {
      const { pages, format, inside = 'png', quality = 0 } = wish;
      // The pictures are what counts in a file of several.
      const picture = pictureIn(format, inside, await engine.givesWebp());
      const about =
        pages.length > 0
          ? await estimated(engine, pages, { format: picture, quality, signal: stop.signal }).catch(() => null)
          : null;
      if (stop.signal.aborted) return;
      setBytes(about === null ? null : about * (wish.print?.plates ? PLATES : 1) * (format === 'html' ? AS_TEXT : 1));
      setBusy(false);
    });
    return () => {
      cancel();
      stop.abort();
    };
  }, [wish]);
  const carries = wish.format === 'png' || isArchive(wish.format);
  const photos = carries ? keeping.pageFiles.photoBytes() : 0;
  const text =
    busy && bytes === null
      ? strings.measuring
      : bytes === null
        ? ''
        : strings.aboutSize({ size: strings.fileSize(bytes + photos) });
  return (
    <output class="file-size" aria-busy={busy}>
      {text}
    </output>
  );
}
