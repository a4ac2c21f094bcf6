/** All languages at once, for tests: the page loads one. */

import { compose } from './compose.ts';
import * as english from './en/index.ts';
import { filled } from './partial.ts';
import type { Translation } from './compose.ts';

const folders = import.meta.glob(['./*/index.ts', '!./en/index.ts'], { eager: true }) as Record<string, Translation>;

/** By code. */
export const translations: Record<string, Translation> = {
  en: english,
  ...Object.fromEntries(Object.entries(folders).map(([path, translation]) => [path.split('/')[1], translation])),
};

/** All strings of the app in a language, with English for missing texts. */
export const inLanguage = (code: string) =>
  compose(code, { ...translations[code], words: filled(translations[code].words, english.words) });
