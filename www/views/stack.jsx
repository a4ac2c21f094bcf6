// @ts-check
/** Photos that look alike: closed, the one that is used stands for all; open, each can be taken, or several kept. */

import { useEffect, useRef } from 'preact/hooks';
import { isUsed } from '../state/album.js';
import { strings } from '../strings.js';
import { useApp } from './context.js';
import { Icon } from './icon.jsx';
import { PhotoTile } from './photo-tile.jsx';

/** @typedef {import('../state/project.js').TrayItem} TrayItem */

/**
 * The stack of each photo that has one.
 * @param {readonly TrayItem[]} tray
 * @param {ReadonlyMap<string, import('../state/album.js').Verdict>} verdicts
 * @returns {Map<string, TrayItem[]>}
 */
export function stacks(tray, verdicts) {
  /** @type {Map<number, TrayItem[]>} */
  const groups = new Map();
  for (const item of tray) {
    const group = verdicts.get(item.id)?.group;
    if (group !== undefined) groups.set(group, [...(groups.get(group) ?? []), item]);
  }
  const several = [...groups.values()].filter((items) => items.length > 1);
  return new Map(several.flatMap((items) => items.map((item) => [item.id, items])));
}

/** @param {{ items: TrayItem[] }} props */
export function Stack({ items }) {
  const { store, choosing, ui } = useApp();
  const button = useRef(/** @type {HTMLButtonElement | null} */ (null));
  const verdicts = store.verdicts.value;
  const ids = items.map(({ id }) => id);
  const used = items.filter((item) => isUsed(item, verdicts));
  // The button that opened it is gone.
  useEffect(() => button.current?.focus(), []);
  return (
    <li class="stack">
      <button ref={button} type="button" class="stack-head" aria-expanded="true" onClick={() => { ui.stack.value = null; }}>
        <span>{strings.stackOf(items.length)}</span>
        <Icon name="close" />
      </button>
      <ul class="photos">
        {items.map((item) => (
          <PhotoTile
            key={item.id}
            item={item}
            used={used.includes(item)}
            onTake={used.length === 1 && used[0] === item ? undefined : () => choosing.take(item.id, ids)}
          />
        ))}
      </ul>
    </li>
  );
}
