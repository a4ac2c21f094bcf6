// @ts-check
/** The language of the page, each named in itself. The words are chosen once a load, so another loads the page again. */

import { language, strings } from '../strings.js';
import { LANGUAGES, rememberLanguage } from '../strings/language.js';
import { useApp } from './context.js';

/** @typedef {import('../strings/language.js').Language} Language */

export function LanguageChoice() {
  const { keeping, messages } = useApp();

  /** @param {Language} chosen */
  async function choose(chosen) {
    rememberLanguage(chosen);
    await keeping.flush();
    const state = keeping.status.peek();
    if (state === 'saved' || state === 'empty') window.location.reload();
    else messages.alert(strings.languageLater(LANGUAGES[chosen]));
  }

  return (
    <label class="language" title={strings.languageHelp}>
      <span>{strings.language}</span>
      <select class="select" value={language} onChange={({ currentTarget }) => void choose(/** @type {Language} */ (currentTarget.value))}>
        {Object.entries(LANGUAGES).map(([code, name]) => <option key={code} value={code} lang={code}>{name}</option>)}
      </select>
    </label>
  );
}
