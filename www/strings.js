// @ts-check
/**
 * Every word on the page, in the language of this visit. A language is a folder of `strings/` with the areas of
 * `strings/en/`; it is chosen once, before anything is drawn, so words never change under a running page.
 */

import { english } from './strings/en/index.js';
import { everyStrings } from './strings/every.js';
import { currentLanguage } from './strings/language.js';

export const language = currentLanguage();

const words = english;

if (typeof document !== 'undefined') document.documentElement.lang = language;

export const strings = { ...everyStrings, ...words };
