/** The functions that compiled messages call: numbers of a locale, and plural forms of a language. */

import type { numbersIn } from './numbers.ts';

export type Formats = ReturnType<typeof formatsIn>;

/** @param language selects the plural forms */
export function formatsIn(language: string, { decimal }: Pick<ReturnType<typeof numbersIn>, 'decimal'>) {
  const rules = new Intl.PluralRules(language);
  return {
    number: (value: number) => decimal(value),
    /** @param forms by plural category, or by an exact number: `=1` */
    plural: (value: number, forms: Readonly<Record<string, string>>) =>
      forms[`=${value}`] ?? forms[rules.select(value)] ?? forms.other,
    select: (value: string, forms: Readonly<Record<string, string>>) =>
      Object.hasOwn(forms, value) ? forms[value] : forms.other,
  };
}
