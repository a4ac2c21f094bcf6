// @ts-check
/**
 * The photos: those on the table, and those set aside with the reason.
 */

import { isUsed } from '../state/album.js';
import { strings } from '../strings.js';
import { Bitmap, screenPixels } from './bitmap.jsx';
import { IconButton } from './button.jsx';
import { useApp } from './context.js';
import { openFiles } from './file-input.jsx';
import { Icon } from './icon.jsx';
import { PhotoSubjects } from './subject-boxes.jsx';
import { Videos } from './videos.jsx';
import { PHOTO } from './panel-gestures.js';

/** @typedef {import('../state/project.js').TrayItem} TrayItem */

/** A style without blocks shows the photo as it is. */
const PLAIN = { id: 'plain', name: 'Plain', tags: [], background: [] };
const SIDE = 96;

export function Tray() {
  const { store, subjects, ui } = useApp();
  const tray = store.tray.value;
  const verdicts = store.verdicts.value;
  const reading = store.reading.value;
  const finding = subjects.progress.value;
  const kept = tray.filter((item) => isUsed(item, verdicts));
  const aside = tray.filter((item) => !isUsed(item, verdicts));
  return (
    <section class="tray" aria-label={strings.photos} aria-busy={reading !== null}>
      <header class="section-head">
        <h2>{strings.photos}</h2>
        {finding
          ? <span class="count" title={strings.findingLong(finding.done, finding.total)}>{strings.finding(finding.done, finding.total)}</span>
          : <span class="count">{strings.photoCount(kept.length, tray.length)}</span>}
        <IconButton icon="subjects" label={strings.showSubjects} pressed={ui.subjects.value} onClick={() => { ui.subjects.value = !ui.subjects.value; }} />
        <IconButton icon="add" label={strings.addPhotos} onClick={openFiles} />
      </header>
      {reading && <Reading done={reading.done} total={reading.total} />}
      <Videos />
      <ul class="photos">{kept.map((item) => <Photo key={item.id} item={item} used />)}</ul>
      {aside.length > 0 && <h3 class="aside-head">{strings.setAside}</h3>}
      {aside.length > 0 && <ul class="photos">{aside.map((item) => <Photo key={item.id} item={item} used={false} />)}</ul>}
    </section>
  );
}

/** @param {import('../state/store.js').Progress} props */
function Reading({ done, total }) {
  const { reading } = useApp();
  const label = strings.reading(done, total);
  return (
    <div class="reading">
      <progress class="progress" aria-label={label} title={label} value={done} max={total} />
      <IconButton icon="close" label={strings.cancelReading} onClick={reading.cancel} />
    </div>
  );
}

/** @param {{ item: TrayItem, used: boolean }} props */
function Photo({ item: { id }, used }) {
  const { store, reading, engine, selection, framing, ui } = useApp();
  const [panel, ...others] = selection.panels.value;
  const takes = panel !== undefined && others.length === 0 && !framing.isLocked(panel);
  const fact = store.album.value.get(id);
  const verdict = store.verdicts.value.get(id);
  const name = fact?.name ?? id;
  const ready = fact?.meta !== null && engine.hasPhoto(id);
  const about = [fact?.credit ?? name, verdict?.why].filter(Boolean).join('\n');
  return (
    <li
      class="photo"
      data-used={used}
      title={about}
      draggable={ready}
      onDragStart={(event) => event.dataTransfer?.setData(PHOTO, id)}
    >
      <label class="photo-picture">
        {ready
          ? <Bitmap of={id} draw={(call) => engine.stylePhoto(id, PLAIN, cover(fact?.meta), call)} />
          : <span class="bitmap" />}
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
      <span class="photo-name">{fact?.credit ?? name}</span>
      {verdict && <span class="photo-why" id={`why-${id}`}>{verdict.why}</span>}
    </li>
  );
}

/**
 * The square in the middle of a photo.
 * @param {{ width: number, height: number } | null | undefined} meta
 */
function cover(meta) {
  const { width, height } = meta ?? { width: 1, height: 1 };
  const side = Math.min(width, height);
  const crop = { x: (1 - side / width) / 2, y: (1 - side / height) / 2, width: side / width, height: side / height };
  return { width: screenPixels(SIDE), height: screenPixels(SIDE), crop };
}
