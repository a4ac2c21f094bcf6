/** A photo on the table: its picture, whether it is used and why not, and what can be done with it. */

import { useComputed } from '@preact/signals';
import { strings } from '../strings/strings.ts';
import { Bitmap } from '../ui/bitmap.tsx';
import { useApp } from '../ui/context.ts';
import { PLAIN, thumbnail } from './cover.ts';
import { Icon } from '../ui/icon.tsx';
import { PHOTO } from './photo-drag.ts';
import { PhotoSubjects } from './subject-boxes.tsx';
import type { TrayItem } from '../document/project.ts';

const SIDE = 96;

/** @param props `stack`: how many it stands for, on top of a closed stack; `onTake`: to take it in place of the others */
export function PhotoTile({
  item: { id, starred = false },
  used,
  stack = 0,
  onTake,
}: {
  item: TrayItem;
  used: boolean;
  stack?: number;
  onTake?: () => void;
}) {
  const { store, reading, choosing, engine, selection, framing, ui } = useApp();
  const [panel, ...others] = selection.panels.value;
  const takes = panel !== undefined && others.length === 0 && !framing.isLocked(panel);
  // Each photo that arrives makes another album; only its own tile is drawn anew.
  const fact = useComputed(() => store.album.value.get(id)).value;
  const verdict = useComputed(() => store.verdicts.value.get(id)).value;
  const name = fact?.name ?? id;
  const ready = fact?.meta !== null && engine.hasPhoto(id);
  const about = [fact?.credit ?? name, verdict && strings.verdict(verdict.why)].filter(Boolean).join('\n');
  return (
    <li
      class="photo"
      data-used={used}
      data-stack={stack > 1}
      title={about}
      draggable={ready}
      onDragStart={(event) => event.dataTransfer?.setData(PHOTO, id)}
    >
      <label class="photo-picture">
        {ready ? (
          <Bitmap of={id} draw={(call) => engine.stylePhoto(id, PLAIN, thumbnail(fact?.meta, SIDE), call)} />
        ) : (
          <span class="bitmap" />
        )}
        {ui.subjects.value && <PhotoSubjects id={id} />}
        <input
          type="checkbox"
          aria-label={strings.usePhoto(name)}
          aria-describedby={verdict && `why-${id}`}
          checked={used}
          onChange={(event) => reading.use(id, event.currentTarget.checked)}
        />
      </label>
      <button
        type="button"
        class="photo-star"
        aria-label={strings.starPhoto(name)}
        aria-pressed={starred}
        title={strings.starLong}
        onClick={() => choosing.star(id, !starred)}
      >
        <Icon name="star" />
      </button>
      <button
        type="button"
        class="photo-remove"
        aria-label={strings.removePhoto(name)}
        title={strings.removePhoto(name)}
        onClick={() => reading.remove(id)}
      >
        <Icon name="close" />
      </button>
      {takes && ready && (
        <button
          type="button"
          class="photo-put"
          aria-label={strings.putHere(name, panel + 1)}
          title={strings.putHere(name, panel + 1)}
          onClick={() => framing.replace(panel, id)}
        >
          <Icon name="put" />
        </button>
      )}
      {stack > 1 && (
        <button
          type="button"
          class="photo-stack"
          aria-expanded="false"
          aria-label={strings.openStack(stack, name)}
          title={strings.openStack(stack, name)}
          onClick={() => {
            ui.stack.value = id;
          }}
        >
          {stack}
        </button>
      )}
      {onTake && (
        <button type="button" class="photo-take" aria-label={strings.takeInstead(name)} onClick={onTake}>
          {strings.take}
        </button>
      )}
      <span class="photo-name">{fact?.credit ?? name}</span>
      {fact?.absent && <span class="photo-why photo-missing">{strings.photoMissing}</span>}
      {verdict && (
        <span class="photo-why" id={`why-${id}`}>
          {strings.verdict(verdict.why)}
        </span>
      )}
    </li>
  );
}
