/** How Shuffle chooses styles. */

import { useRef } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { useApp } from '../ui/context.ts';

export function StyleShuffle() {
  const { store, styling, taste, actions } = useApp();
  const { styles } = actions;
  const drags = useRef(0);
  const { invented } = store.project.value.styling;
  return (
    <fieldset class="style-shuffle">
      <legend class="visually-hidden">{strings.styleShuffle}</legend>
      <label class="field">
        <span>{strings.inventedShare}</span>
        <input
          type="range"
          min="0"
          max="1"
          step="0.05"
          value={invented}
          aria-valuetext={strings.percent(invented)}
          onInput={(event) =>
            styling.change({ invented: event.currentTarget.valueAsNumber }, `invented-${drags.current}`)
          }
          onChange={() => {
            drags.current += 1;
          }}
        />
        <output aria-hidden="true">{strings.percent(invented)}</output>
      </label>
      <div class="style-locks">
        <ActionButton action={styles.keepColours} class="button small" text />
        <ActionButton action={styles.keepLines} class="button small" text />
      </div>
      <div class="style-taste">
        <label title={strings.learnTasteLong}>
          <input
            type="checkbox"
            checked={taste.on.value}
            onChange={(event) => taste.setOn(event.currentTarget.checked)}
          />
          <span>{strings.learnTaste}</span>
        </label>
        <ActionButton action={styles.forgetTaste} class="button small" text />
      </div>
    </fieldset>
  );
}
