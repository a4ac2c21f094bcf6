/**
 * Shuffle, the big button, and its three parts, each with its lock.
 */

import { strings } from '../strings/strings.ts';
import { useApp } from '../app/context.ts';
import { Icon } from '../ui/icon.tsx';
import type { Part } from '../document/project.ts';

const PARTS: { part: Part; key: string }[] = [
  { part: 'layout', key: 'L' },
  { part: 'style', key: 'S' },
  { part: 'photos', key: 'P' },
];

export function ShuffleButton() {
  const { store, pages } = useApp();
  return (
    <button
      type="button"
      class="shuffle"
      title={`${strings.shuffle} (Space)`}
      aria-keyshortcuts="Space"
      disabled={store.page.value === null}
      onClick={() => pages.shuffle('all')}
    >
      <Icon name="shuffle" />
      <span>{strings.shuffle}</span>
    </button>
  );
}

export function ShuffleParts() {
  const { store, pages } = useApp();
  const { locks, page } = store.project.value;
  return (
    <div class="parts">
      {PARTS.map(({ part, key }) => (
        <div class="part" key={part} data-locked={locks[part]}>
          <button
            type="button"
            class="part-shuffle"
            aria-label={strings.shufflePart[part]}
            aria-keyshortcuts={key}
            title={`${strings.shufflePart[part]} (${key})`}
            disabled={page === null || locks[part]}
            onClick={() => pages.shuffle(part)}
          >
            <Icon name={part} />
            <span>{strings.part[part]}</span>
          </button>
          <button
            type="button"
            class="part-lock"
            aria-label={strings.lockPart[part]}
            aria-pressed={locks[part]}
            title={strings.lockPart[part]}
            onClick={() => pages.lock(part, !locks[part])}
          >
            <Icon name={locks[part] ? 'lock' : 'unlock'} />
          </button>
        </div>
      ))}
    </div>
  );
}
