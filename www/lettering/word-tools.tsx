/** Words in the side: added, listed, and the one that is chosen changed. Every drag on the page has its click or field here. */

import { useRef } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { ChosenFiles } from '../photos/chosen-files.tsx';
import { useApp } from '../ui/context.ts';
import { Icon } from '../ui/icon.tsx';
import { WordFields } from './word-fields.tsx';
import { ActionButton } from '../ui/action-button.tsx';

export function WordTools() {
  const { lettering, actions } = useApp();
  const words = lettering.words.value;
  const chosen = lettering.chosen.value;

  return (
    <section class="word-tools" aria-label={strings.words}>
      <div class="word-adders">
        {Object.values(actions.words).map((action) => (
          <ActionButton key={action.label} action={action} class="button small" text />
        ))}
      </div>
      {words.length === 0 && <p class="quiet">{strings.noWords}</p>}
      {words.length > 0 && (
        <ul class="word-list" aria-label={strings.wordList}>
          {words.map(({ kind, text }, i) => (
            <li key={i}>
              <button
                type="button"
                class="word-entry"
                aria-expanded={i === chosen}
                onClick={() => lettering.choose(i === chosen ? -1 : i)}
              >
                <Icon name={kind} />
                <span>{text}</span>
              </button>
              {i === chosen && <WordFields index={i} />}
            </li>
          ))}
        </ul>
      )}
      <Subtitles />
    </section>
  );
}

function Subtitles() {
  const { subtitling, store } = useApp();
  const file = useRef(null as HTMLInputElement | null);
  if (store.videos.value.size === 0) return null;
  return (
    <fieldset class="subtitles">
      <legend>{strings.subtitles}</legend>
      <label class="field">
        <span>{strings.subtitlesAs}</span>
        <select
          class="select"
          value={subtitling.kind.value}
          onChange={({ currentTarget }) => {
            subtitling.kind.value = currentTarget.value as 'caption';
          }}
        >
          {(['caption', 'balloon'] as const).map((kind) => (
            <option key={kind} value={kind}>
              {strings.subtitlesKinds[kind]}
            </option>
          ))}
        </select>
      </label>
      <button type="button" class="button small" onClick={() => file.current?.click()}>
        <Icon name="open" />
        {strings.addSubtitles}
      </button>
      <ChosenFiles input={file} accept=".srt,.vtt,text/vtt" label={strings.subtitlesFile} onFiles={subtitling.open} />
    </fieldset>
  );
}
