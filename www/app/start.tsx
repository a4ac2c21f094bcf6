/**
 * The empty page: one sentence, two buttons, and a promise.
 */

import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { openFiles } from '../photos/file-input.tsx';
import { Icon } from '../ui/icon.tsx';
import { InstallButton } from '../offline/install.tsx';
import { Broken } from '../storage/broken.tsx';
import { Elsewhere } from '../storage/elsewhere.tsx';
import { LanguageChoice } from '../help/language-choice.tsx';
import { Illustration } from '../ui/illustration.tsx';

export function Start() {
  const { reading, store } = useApp();
  return (
    <main class="start">
      <div class="start-body">
        <Illustration />
        <div class="start-words">
          <Elsewhere />
          <Broken />
          <h1>
            {strings.lead.map((line) => (
              <span key={line}>{line} </span>
            ))}
          </h1>
          <p class="start-more">{strings.leadMore}</p>
          <div class="start-buttons">
            <button type="button" class="button strong large" onClick={openFiles}>
              <Icon name="photos" />
              {strings.chooseFiles}
            </button>
            <button type="button" class="button large" aria-busy={store.fetching.value} onClick={reading.addSamples}>
              {strings.trySamples}
            </button>
          </div>
          <div class="start-foot">
            <p class="start-promise">
              <Icon name="lock" />
              {strings.privacy}
            </p>
            <InstallButton />
            <LanguageChoice />
          </div>
          {store.planner.value === null && (
            <p class="visually-hidden" role="status">
              {strings.starting}
            </p>
          )}
        </div>
      </div>
    </main>
  );
}
