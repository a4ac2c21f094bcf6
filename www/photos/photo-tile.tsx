/** A photo in the tray: its thumbnail, its status with the reason, and its actions. */

import { useComputed } from '@preact/signals';
import { useRef } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { noteWithUndo } from '../ui/undo-note.ts';
import { Thumbnail } from '../ui/bitmap.tsx';
import { useApp } from '../ui/context.ts';
import { PLAIN, thumbnail } from './cover.ts';
import { Icon } from '../ui/icon.tsx';
import { PHOTO } from './photo-drag.ts';
import { PhotoSubjects } from './subject-boxes.tsx';
import type { PageDocument } from '../engine/types.ts';
import type { TrayItem } from '../document/project.ts';

const SIDE = 96;
/** The key that rotates the focused photo. */
const ROTATE = 'R';

/**
 * @param props `stack`: number of photos in its closed stack; `onTake`: uses it instead of the others; `isStop`: whether Tab
 *   reaches its controls
 */
export function PhotoTile({
  item: { id, use, starred = false },
  used,
  stack = 0,
  onTake,
  isStop = true,
}: {
  item: TrayItem;
  used: boolean;
  stack?: number;
  onTake?: () => void;
  isStop?: boolean;
}) {
  const { store, pages, reading, choosing, rotating, engine, selection, framing, messages, ui } = useApp();
  const tile = useRef(null as HTMLLIElement | null);
  const [panel, ...others] = selection.panels.value;
  const takes = panel !== undefined && others.length === 0 && !framing.isLocked(panel);
  // Each new photo changes the album, but only its own tile is drawn again.
  const fact = useComputed(() => store.album.value.get(id)).value;
  const reason = useComputed(() => store.reasons.value.get(id)).value;
  const name = fact?.name ?? id;
  const ready = fact?.meta !== null && engine.hasPhoto(id);
  const why = reason ? strings.verdict(reason) : use === false ? strings.youLeftOut : undefined;
  const unseen = useComputed(() => (used ? store.unseen.value.get(id) : undefined)).value;
  const waiting = unseen && strings.unseen[unseen];
  const about = [fact?.credit ?? name, why, waiting, ready && strings.pickLong].filter(Boolean).join('\n');
  const short = useComputed(() => shownOn(store.sheets.value, id, false)).value;
  const long = useComputed(() => shownOn(store.sheets.value, id, true)).value;
  const picked = framing.placing.value === id;
  const tabIndex = isStop ? undefined : -1;

  function pick() {
    if (takes) framing.replace(panel, id);
    else framing.place(picked ? null : id);
  }

  function setUsed(on: boolean) {
    reading.use(id, on);
    if (!on) noteWithUndo({ messages, store, pages }, strings.leftOut({ name }));
  }

  /** Rotates by a quarter. The rotated photo has another tile, which gets the focus and remains picked. */
  async function rotate() {
    const focused = tile.current?.contains(document.activeElement);
    const { className = '' } = (focused && document.activeElement) || {};
    const fresh = await rotating.rotate(() => id, 'right');
    if (fresh === undefined) return;
    if (picked) framing.place(fresh);
    requestAnimationFrame(() => {
      const next = document.querySelector(`.photo[data-photo="${CSS.escape(fresh)}"]`);
      if (focused)
        next?.querySelector<HTMLElement>(className === 'photo-rotate' ? '.photo-rotate' : '.photo-picture')?.focus();
    });
  }

  return (
    <li
      class="photo"
      ref={tile}
      data-photo={id}
      data-used={used}
      data-stack={stack > 1}
      title={about}
      draggable={ready}
      onDragStart={(event) => event.dataTransfer?.setData(PHOTO, id)}
    >
      {/* No button element: Firefox drags nothing by one. */}
      <div
        class="photo-picture"
        role="button"
        tabIndex={ready && isStop ? 0 : -1}
        aria-label={strings.pickPhoto({ name })}
        aria-description={long || undefined}
        aria-pressed={picked}
        aria-disabled={!ready}
        onClick={() => ready && pick()}
        aria-keyshortcuts={ROTATE}
        onKeyDown={(event) => {
          const { key, ctrlKey, metaKey, altKey } = event;
          const rotates = key.toUpperCase() === ROTATE && !ctrlKey && !metaKey && !altKey && !fact?.absent;
          if (!ready || !(rotates || key === 'Enter' || key === ' ')) return;
          event.preventDefault();
          event.stopPropagation();
          if (rotates) void rotate();
          else pick();
        }}
      >
        {ready ? (
          <Thumbnail of={id} draw={(call) => engine.photoFile(id, PLAIN, thumbnail(fact?.meta, SIDE), call)} />
        ) : (
          <span class="bitmap" />
        )}
        {ui.subjects.value && <PhotoSubjects id={id} />}
        {fact?.time !== undefined && (
          <span class="photo-time" aria-hidden="true">
            {strings.clock(fact.time)}
          </span>
        )}
        {short && (
          <span class="photo-places" aria-hidden="true">
            {short}
          </span>
        )}
      </div>
      <label class="photo-use">
        <input
          type="checkbox"
          tabIndex={tabIndex}
          aria-label={strings.usePhoto({ name })}
          aria-describedby={why && `why-${id}`}
          checked={used}
          onChange={(event) => setUsed(event.currentTarget.checked)}
        />
      </label>
      <button
        type="button"
        class="photo-star"
        tabIndex={tabIndex}
        aria-label={strings.starPhoto({ name })}
        aria-pressed={starred}
        title={strings.starLong}
        onClick={() => choosing.star(id, !starred)}
      >
        <Icon name="star" />
      </button>
      <button
        type="button"
        class="photo-remove"
        tabIndex={tabIndex}
        aria-label={strings.removePhoto({ name })}
        title={strings.removePhoto({ name })}
        onClick={() => reading.remove(id)}
      >
        <Icon name="close" />
      </button>
      {picked && !takes && ready && !fact?.absent && (
        <button
          type="button"
          class="photo-put photo-correct"
          tabIndex={tabIndex}
          aria-label={strings.brush.correctPhoto({ name })}
          title={strings.brush.correctPhoto({ name })}
          onClick={() => {
            ui.dialog.value = { brush: id };
          }}
        >
          <Icon name="brush" />
        </button>
      )}
      {ready && !fact?.absent && (
        <button
          type="button"
          class="photo-rotate"
          data-picked={picked}
          tabIndex={picked && isStop ? 0 : -1}
          aria-label={strings.rotateNamed({ name })}
          title={`${strings.rotatePhoto} (${ROTATE})`}
          onClick={() => void rotate()}
        >
          <Icon name="rotate" />
        </button>
      )}
      {takes && ready && (
        <button
          type="button"
          class="photo-put"
          tabIndex={tabIndex}
          aria-label={strings.putHere({ photo: name, panel: panel + 1 })}
          title={strings.putHere({ photo: name, panel: panel + 1 })}
          onClick={() => framing.replace(panel, id)}
        >
          <Icon name="put" />
        </button>
      )}
      {stack > 1 && (
        <button
          type="button"
          class="photo-stack"
          tabIndex={tabIndex}
          aria-expanded="false"
          aria-label={strings.openStack({ count: stack, name })}
          title={strings.openStack({ count: stack, name })}
          onClick={() => {
            ui.stack.value = id;
          }}
        >
          {stack}
        </button>
      )}
      {onTake && (
        <button
          type="button"
          class="photo-take"
          tabIndex={tabIndex}
          aria-label={strings.takeInstead({ name })}
          onClick={onTake}
        >
          {strings.take}
        </button>
      )}
      <span class="photo-name">{fact?.credit ?? name}</span>
      {fact?.absent && <span class="photo-why photo-missing">{strings.photoMissing}</span>}
      {waiting && <span class="photo-why photo-unseen">{waiting}</span>}
      {why && (
        <span class="photo-why" id={`why-${id}`}>
          {why}
        </span>
      )}
    </li>
  );
}

/** Pages and panels that show a photo, as text, so that a tile is only drawn again after a change. */
function shownOn(pages: readonly PageDocument[], id: string, long: boolean): string {
  const several = pages.length > 1;
  const places = pages.flatMap(({ panels }, at) =>
    panels.flatMap(({ photo }, i) => (photo === id ? [{ page: at + 1, panel: i + 1 }] : [])),
  );
  if (several && !long) {
    const numbers = [...new Set(places.map(({ page }) => page))].join(', ');
    return numbers && strings.onPages({ pages: numbers });
  }
  const say = several ? strings.onPageAndPanelLong : long ? strings.onPanelLong : strings.onPanel;
  return places.map(say).join(', ');
}
