/** All languages at once, for tests: the page loads one. */

import { compose } from './compose.ts';
import { formatsIn } from './formats.ts';
import { numbersIn } from './numbers.ts';
import type { Messages } from './compiled/help-en.ts';
import type { Translation } from './compose.ts';
import type { Formats } from './formats.ts';

type Help = { messages: (formats: Formats) => Messages };

/** @returns modules by language */
const byCode = <T>(modules: Record<string, unknown>) =>
  Object.fromEntries(
    Object.entries(modules).map(([path, module]) => [path.replace(/^.*[/-]|\.ts$/g, ''), module]),
  ) as Record<string, T>;

export const translations = byCode<Translation>(import.meta.glob('./compiled/??.ts', { eager: true }));
const helps = byCode<Help>(import.meta.glob('./compiled/help-*.ts', { eager: true }));

/** All strings of the app in a language, with English for missing texts. */
export const inLanguage = (code: string) => compose(code, translations[code]);

/** The topics of the help in a language. */
export const helpIn = (code: string) => helps[code].messages(formatsIn(code, numbersIn(code)));
