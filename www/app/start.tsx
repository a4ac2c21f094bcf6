/**
 * The start screen: one sentence, two buttons, a promise, pages of the sample album, and recent projects. `index.html` has its
 * pictures, which this view takes over.
 */

import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { useApp } from '../ui/context.ts';
import { Icon } from '../ui/icon.tsx';
import { InstallButton } from '../offline/install.tsx';
import { Broken } from '../storage/broken.tsx';
import { Elsewhere } from '../storage/elsewhere.tsx';
import { LanguageChoice } from '../help/language-choice.tsx';
import { RecentProjects } from '../storage/recent-projects.tsx';

/** Pages of the sample album, made with this app; `public/samples/PROVENANCE.md` names the photos. */
const PAGES = ['line', 'moonlight', 'golden-age'];
/** Their width on the screen, also in `index.html`. */
const SIZES = '(width <= 760px) min(36vw, 19dvh), 270px';

/** Whether the pointer is a finger, which cannot drop files. */
const isTouch = () => window.matchMedia('(pointer: coarse)').matches;

export function Start() {
  const { actions, store } = useApp();
  return (
    <main class="start">
      <div class="start-body">
        <div class="start-pages" role="img" aria-label={strings.startPages}>
          {PAGES.map((page) => (
            <img
              key={page}
              src={`./start/${page}.webp`}
              srcset={`./start/${page}-small.webp 300w, ./start/${page}.webp 420w`}
              sizes={SIZES}
              alt=""
              width="420"
              height="594"
            />
          ))}
        </div>
        <div class="start-words">
          <Elsewhere />
          <Broken />
          <h1>
            {Object.values(isTouch() ? strings.leadTouch : strings.lead).map((line) => (
              <span key={line}>{line} </span>
            ))}
          </h1>
          <p class="start-more">{strings.leadMore}</p>
          <div class="start-buttons">
            <ActionButton action={actions.photos.choose} class="button strong large" text />
            <ActionButton action={actions.photos.trySamples} class="button large" text busy={store.fetching.value} />
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
        <RecentProjects />
      </div>
    </main>
  );
}
