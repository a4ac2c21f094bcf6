/**
 * The `Text` tab: adding and listing text items, and editing the selected one. Every drag on the page has its click or
 * field here.
 */

import { useRef } from 'preact/hooks';
import { MOST } from '../document/limits.ts';
import { endingsOf } from '../engine/file-kinds.ts';
import { strings } from '../strings/strings.ts';
import { IconButton } from '../ui/button.tsx';
import { ChosenFiles } from '../photos/chosen-files.tsx';
import { useApp } from '../ui/context.ts';
import { Icon } from '../ui/icon.tsx';
import { FilmSoundTools } from './film-sound-tools.tsx';
import { WordFields } from './word-fields.tsx';
import { ActionButton } from '../ui/action-button.tsx';

/** Maximum number of listed unplaced items, because a whole video may have thousands. */
const LISTED = 100;

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
      <Waiting />
      <Speech />
      <FilmSoundTools />
    </section>
  );
}

/** Words whose photos no page shows. */
function Waiting() {
  const { lettering } = useApp();
  const words = lettering.waiting.value;
  if (words.length === 0) return null;
  return (
    <details class="waiting">
      <summary>{strings.wordsWaiting({ n: words.length })}</summary>
      <p class="quiet">{strings.wordsWaitingWhy}</p>
      <ul class="waiting-words">
        {words.slice(0, LISTED).map(({ text }, i) => (
          <li key={i}>
            <span title={text}>{text}</span>
            <IconButton icon="put" label={strings.putWaiting({ text })} onClick={() => lettering.take(i)} />
            <IconButton icon="bin" label={strings.dropWaiting({ text })} onClick={() => lettering.drop([i])} />
          </li>
        ))}
      </ul>
      <button type="button" class="button small" onClick={() => lettering.drop(words.map((_, i) => i))}>
        <Icon name="bin" />
        {strings.dropAllWaiting}
      </button>
    </details>
  );
}

/** Scripts and subtitles, which become balloons. */
function Speech() {
  const { subtitling, store } = useApp();
  const file = useRef(null as HTMLInputElement | null);
  const script = subtitling.draft.value;

  async function put() {
    if (await subtitling.put(subtitling.draft.peek())) subtitling.draft.value = '';
  }

  return (
    <fieldset class="subtitles">
      <legend>{strings.script}</legend>
      <textarea
        class="script-text"
        aria-label={strings.scriptText}
        placeholder={strings.scriptSample}
        maxLength={MOST.script}
        value={script}
        onInput={({ currentTarget }) => {
          subtitling.draft.value = currentTarget.value;
        }}
      />
      <p class="quiet">{strings.scriptHelp}</p>
      <label class="field">
        <span>{strings.subtitlesAs}</span>
        <select
          class="select"
          value={subtitling.kind.value}
          onChange={({ currentTarget }) => {
            subtitling.kind.value = currentTarget.value as 'caption';
          }}
        >
          {(['balloon', 'caption'] as const).map((kind) => (
            <option key={kind} value={kind}>
              {strings.subtitlesKinds[kind]}
            </option>
          ))}
        </select>
      </label>
      <label class="check">
        <input
          type="checkbox"
          checked={subtitling.sounds.value}
          onChange={({ currentTarget }) => {
            subtitling.sounds.value = currentTarget.checked;
          }}
        />
        <span>{strings.soundsAsEffects}</span>
      </label>
      <div class="speech-deeds">
        <button
          type="button"
          class="button small"
          disabled={script.trim() === '' || store.page.value === null}
          onClick={() => void put()}
        >
          <Icon name="balloon" />
          {strings.putScript}
        </button>
        <button type="button" class="button small" onClick={() => file.current?.click()}>
          <Icon name="open" />
          {strings.addSubtitles}
        </button>
      </div>
      <ChosenFiles
        input={file}
        accept={`${endingsOf('subtitles', 'text')},text/vtt,text/plain`}
        label={strings.subtitlesFile}
        onFiles={subtitling.open}
      />
    </fieldset>
  );
}
