/** The language menu. Each language has its own name. The language is loaded once, so changing it reloads the page. */

import { language, strings } from '../strings/strings.ts';
import { LANGUAGES, rememberLanguage } from '../strings/language.ts';
import { useApp } from '../ui/context.ts';
import type { Language } from '../strings/language.ts';

export function LanguageChoice() {
  const { keeping, messages } = useApp();

  async function choose(chosen: Language) {
    rememberLanguage(chosen);
    await keeping.flush();
    const state = keeping.status.peek();
    if (state === 'saved' || state === 'empty') window.location.reload();
    else messages.alert(strings.languageLater({ name: LANGUAGES[chosen] }));
  }

  return (
    <label class="language" title={strings.languageHelp}>
      <span>{strings.language}</span>
      <select
        class="select"
        value={language}
        onChange={({ currentTarget }) => void choose(currentTarget.value as Language)}
      >
        {Object.entries(LANGUAGES).map(([code, name]) => (
          <option key={code} value={code} lang={code}>
            {name}
          </option>
        ))}
      </select>
    </label>
  );
}
