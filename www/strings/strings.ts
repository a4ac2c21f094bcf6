/**
 * All strings of the app, in the current language. It is chosen once before the first draw, so strings never change in a
 * running page. `compile.js` makes the modules of `compiled/` from the message catalogues.
 */

import * as english from './compiled/en.ts';
import { compose } from './compose.ts';
import { formatsIn } from './formats.ts';
import { browserLanguages, currentLanguage, localeOf } from './language.ts';
import { numbersIn } from './numbers.ts';
import type { Translation } from './compose.ts';
import type { Language } from './language.ts';

/** Only English is part of the first download. The other modules import nothing: this module waits for them. */
const OTHERS: Record<Exclude<Language, 'en'>, () => Promise<Translation>> = {
  de: () => import('./compiled/de.ts'),
  es: () => import('./compiled/es.ts'),
  fr: () => import('./compiled/fr.ts'),
  ja: () => import('./compiled/ja.ts'),
  pt: () => import('./compiled/pt.ts'),
};

const wanted = currentLanguage();
const translation: Translation = wanted === 'en' ? english : await OTHERS[wanted]().catch(() => english);

/** English if the chosen language cannot be loaded. */
export const language: Language = translation === english ? 'en' : wanted;

if (typeof document !== 'undefined') document.documentElement.lang = language;

const locale = localeOf(language, browserLanguages());

/** Formats for messages that a feature loads separately. */
export const currentFormats = formatsIn(language, numbersIn(locale));

export const strings = compose(language, translation, locale);
