/**
 * All strings of the app, in the current language. A language is a folder of `strings/` with the areas of
 * `strings/en/`. It is chosen once before the first draw, so strings never change in a running page.
 */

import { compose } from './compose.ts';
import * as english from './en/index.ts';
import { browserLanguages, currentLanguage, localeOf } from './language.ts';
import { filled } from './partial.ts';
import type { PartTranslation } from './partial.ts';
import type { Language } from './language.ts';

/**
 * Only English is part of the first download. The files of another language import nothing from outside their folder,
 * types apart: this module waits for them, and would wait for ever if they waited for it.
 */
const OTHERS: Record<Exclude<Language, 'en'>, () => Promise<PartTranslation>> = {
  de: () => import('./de/index.ts'),
  es: () => import('./es/index.ts'),
  fr: () => import('./fr/index.ts'),
  ja: () => import('./ja/index.ts'),
  pt: () => import('./pt/index.ts'),
};

const wanted = currentLanguage();
const translation: PartTranslation = wanted === 'en' ? english : await OTHERS[wanted]().catch(() => english);

/** English if the chosen language cannot be loaded. */
export const language: Language = translation === english ? 'en' : wanted;

if (typeof document !== 'undefined') document.documentElement.lang = language;

/** Missing texts of a language appear in English. */
const words = filled(translation.words, english.words);

export const strings = compose(localeOf(language, browserLanguages()), { ...translation, words });
