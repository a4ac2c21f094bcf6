/** Found topics and keyboard shortcuts, below the search field of the help. */

import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { useApp } from '../ui/context.ts';
import { keyLines } from './key-lines.ts';
import { searchHelp, topicsOf } from './searching.ts';
import { topicMessages } from './topics.ts';
import type { Topic } from './searching.ts';
import type { KeyLine } from './key-lines.ts';

/** @param props `seek` changes the search words */
export function HelpFound({
  sought,
  seek,
  close,
}: {
  sought: string;
  seek: (sought: string) => void;
  close: () => void;
}) {
  const { ui, actions, hints } = useApp();
  const { topics, lines } = searchHelp(sought, topicsOf(topicMessages, strings), keyLines({ ...actions }));
  const searching = sought.trim() !== '';
  const none = topics.length + lines.length === 0;
  const showHints = {
    label: strings.hintsAgain,
    run() {
      close();
      hints.begin();
    },
  };
  return (
    <>
      <p class="help-found quiet" role="status">
        {none
          ? strings.helpNone({ text: sought.trim() })
          : searching
            ? strings.helpFound({ topics: topics.length, keys: lines.length })
            : ''}
      </p>
      {none && <ActionButton action={{ label: strings.allTopics, run: () => seek('') }} class="button" text />}
      <div class="help-found-lists">
        {topics.length > 0 && <Topics of={topics} open={searching} />}
        {lines.length > 0 && <Keys of={lines} />}
      </div>
      {!searching && (
        <div class="help-foot">
          <label class="letter-keys">
            <input
              type="checkbox"
              checked={ui.letterKeys.value}
              onChange={({ currentTarget }) => ui.useLetterKeys(currentTarget.checked)}
            />
            <span>{strings.letterKeys}</span>
          </label>
          <ActionButton action={showHints} class="button" text />
        </div>
      )}
    </>
  );
}

/** A found topic is open. The user opens the others. */
function Topics({ of, open }: { of: readonly Topic[]; open: boolean }) {
  return (
    <section class="help-topics" aria-label={strings.helpTopics}>
      {of.map(({ id, title, text }) => (
        <details key={`${id} ${open}`} open={open}>
          <summary>{title}</summary>
          <p>{text}</p>
        </details>
      ))}
    </section>
  );
}

function Keys({ of }: { of: readonly KeyLine[] }) {
  return (
    <section class="help-keys">
      <h3>{strings.keys}</h3>
      <dl class="keys">
        {of.map(({ keys, does }) => (
          <div key={does}>
            <dt>
              {keys.map((key) => (
                <kbd key={key}>{key}</kbd>
              ))}
            </dt>
            <dd>{does}</dd>
          </div>
        ))}
      </dl>
    </section>
  );
}
