/** The texts of the help, in the current language. They are loaded with the help. */

import { currentFormats, language } from '../strings/strings.ts';
import type { Messages } from '../strings/compiled/help-en.ts';
import type { Formats } from '../strings/formats.ts';
import type { Language } from '../strings/language.ts';

const MODULES: Record<Language, () => Promise<{ messages: (formats: Formats) => Messages }>> = {
  en: () => import('../strings/compiled/help-en.ts'),
  de: () => import('../strings/compiled/help-de.ts'),
  es: () => import('../strings/compiled/help-es.ts'),
  fr: () => import('../strings/compiled/help-fr.ts'),
  ja: () => import('../strings/compiled/help-ja.ts'),
  pt: () => import('../strings/compiled/help-pt.ts'),
};

const { messages } = await MODULES[language]();

export const topicMessages = messages(currentFormats);
