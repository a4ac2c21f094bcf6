/**
 * Every word on the page, in the language of this visit. A language is a folder of `strings/` with the areas of
 * `strings/en/`; it is chosen once, before anything is drawn, so words never change under a running page.
 */

import { english } from './en/index.ts';
import { everyStrings } from './every.ts';
import { currentLanguage } from './language.ts';

export const language = currentLanguage();

/**
 * Only English is part of the first download. The files of another language import nothing from outside their folder:
 * this module waits for them, and would wait for ever if they waited for it.
 */
const words =
  language === 'es'
    ? await import('./es/index.ts').then(
        ({ spanish }) => spanish,
        () => english,
      )
    : english;

if (typeof document !== 'undefined') document.documentElement.lang = words === english ? 'en' : language;

export const strings = { ...everyStrings, ...words };
