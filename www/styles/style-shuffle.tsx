/** How Shuffle chooses styles. */

import { useRef } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';

export function StyleShuffle() {
  const { store, styling, taste } = useApp();
  const drags = useRef(0);
  const { invented, keepLines, keepColours } = store.project.value.styling;
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
        <button
          type="button"
          class="button small"
          aria-pressed={keepColours}
          onClick={() => styling.change({ keepColours: !keepColours })}
        >
          {strings.keepColours}
        </button>
        <button
          type="button"
          class="button small"
          aria-pressed={keepLines}
          onClick={() => styling.change({ keepLines: !keepLines })}
        >
          {strings.keepLines}
        </button>
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
        <button type="button" class="button small" disabled={!taste.known.value} onClick={taste.forget}>
          {strings.forgetTaste}
        </button>
      </div>
    </fieldset>
  );
}
