/**
 * The `Text` tab: adding and listing text items, and editing the selected one. Every drag on the page has its click or
 * field here.
 */

import { useRef } from 'preact/hooks';
import { MOST } from '../document/limits.ts';
import { roleOf, wordName } from '../document/word-names.ts';
import { endingsOf } from '../engine/file-kinds.ts';
import { strings } from '../strings/strings.ts';
import { IconButton } from '../ui/button.tsx';
import { ChosenFiles } from '../photos/chosen-files.tsx';
import { useApp } from '../ui/context.ts';
import { Icon } from '../ui/icon.tsx';
import { useListDrag } from '../ui/list-drag.ts';
import { FilmSoundTools } from './film-sound-tools.tsx';
import { WordFields } from './word-fields.tsx';
import { ActionButton } from '../ui/action-button.tsx';

/** Maximum number of listed unplaced items, because a whole video may have thousands. */
const LISTED = 100;

export function WordTools() {
  const { lettering, actions } = useApp();
  const words = lettering.words.value;

  return (
    <section class="word-tools" aria-label={strings.words}>
      <div class="word-adders">
        {Object.values(actions.words).map((action) => (
          <ActionButton key={action.label} action={action} class="button small" text />
        ))}
      </div>
      {words.length === 0 && <p class="quiet">{strings.noWords}</p>}
      {words.length > 0 && <List />}
      <Waiting />
      <Speech />
      <FilmSoundTools />
    </section>
  );
}

/** The text items in reading order. They are moved by dragging, by Alt with the arrow keys, and by buttons. */
function List() {
  const { lettering } = useApp();
  const list = useRef(null as HTMLOListElement | null);
  const drag = useListDrag({ list: '.word-list', item: '.word-item' }, lettering.reorder);
  const words = lettering.words.value;
  const chosen = lettering.chosen.value;
  const order = lettering.reading.value;
  const gap = drag.carried?.gap ?? -1;

  function carry(from: number, by: number) {
    lettering.reorder(from, from + by);
    const entry = () => list.current?.querySelector<HTMLElement>('.word-entry[aria-expanded="true"]');
    // The browser removes the focus from a moved element.
    requestAnimationFrame(() => entry()?.focus());
  }

  function onKeyDown(event: KeyboardEvent, at: number) {
    const by = { ArrowUp: -1, ArrowDown: 1 }[event.key];
    if (!event.altKey || by === undefined) return;
    event.preventDefault();
    carry(at, by);
  }

  return (
    <ol class="word-list" aria-label={strings.wordList} ref={list}>
      {order.map((index, at) => (
        <li
          key={index}
          class="word-item"
          data-marked={gap === at ? 'before' : gap === order.length && at === order.length - 1 ? 'behind' : undefined}
          data-carried={drag.carried?.from === at || undefined}
        >
          <div class="word-row">
            <button
              type="button"
              class="word-entry"
              aria-expanded={index === chosen}
              aria-description={order.length > 1 ? strings.wordOrderHelp : undefined}
              title={order.length > 1 ? strings.wordOrderHelp : undefined}
              onPointerDown={(event) => drag.take(event, at)}
              onKeyDown={(event) => onKeyDown(event, at)}
              onClick={() => {
                if (!drag.dragged.current) lettering.choose(index === chosen ? -1 : index);
              }}
            >
              <b aria-hidden="true">{at + 1}</b>
              <Icon name={roleOf(words[index])} />
              <span>{words[index].number ? wordName(words[index]) : lettering.textOf(index)}</span>
            </button>
            {index === chosen && order.length > 1 && (
              <>
                <IconButton
                  icon="unfold"
                  label={strings.wordEarlier}
                  disabled={at === 0}
                  onClick={() => carry(at, -1)}
                />
                <IconButton
                  icon="fold"
                  label={strings.wordLater}
                  disabled={at === order.length - 1}
                  onClick={() => carry(at, 1)}
                />
              </>
            )}
          </div>
          {index === chosen && <WordFields index={index} />}
        </li>
      ))}
    </ol>
  );
}

/** Words whose photos no page shows. */
function Waiting() {
  const { lettering, actions } = useApp();
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
      <ActionButton action={actions.text.dropAll} class="button small" text />
    </details>
  );
}

/** Scripts and subtitles, which become balloons. */
function Speech() {
  const { subtitling, actions } = useApp();
  const file = useRef(null as HTMLInputElement | null);
  const script = subtitling.draft.value;

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
        <ActionButton action={actions.text.putScript} class="button small" text />
        <ActionButton
          action={{ label: strings.addSubtitles, icon: 'open', run: () => file.current?.click() }}
          class="button small"
          text
        />
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
