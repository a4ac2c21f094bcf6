// @ts-check
/**
 * The empty page: one sentence, two buttons, and a promise.
 */

import { strings } from '../strings.js';
import { useApp } from './context.js';
import { openFiles } from './file-input.jsx';
import { Icon } from './icon.jsx';
import { InstallButton } from './install.jsx';
import { Broken } from './keeping/broken.jsx';
import { Elsewhere } from './keeping/elsewhere.jsx';
import { LanguageChoice } from './language-choice.jsx';
import { Illustration } from './illustration.jsx';

export function Start() {
  const { reading, store } = useApp();
  return (
    <main class="start">
      <div class="start-body">
        <Illustration />
        <div class="start-words">
          <Elsewhere />
          <Broken />
          <h1>{strings.lead.map((line) => <span key={line}>{line} </span>)}</h1>
          <p class="start-more">{strings.leadMore}</p>
          <div class="start-buttons">
            <button type="button" class="button strong large" onClick={openFiles}>
              <Icon name="photos" />{strings.chooseFiles}
            </button>
            <button type="button" class="button large" aria-busy={store.fetching.value} onClick={reading.addSamples}>
              {strings.trySamples}
            </button>
          </div>
          <div class="start-foot">
            <p class="start-promise"><Icon name="lock" />{strings.privacy}</p>
            <InstallButton />
            <LanguageChoice />
          </div>
          {store.planner.value === null && <p class="visually-hidden" role="status">{strings.starting}</p>}
        </div>
      </div>
    </main>
  );
}
