/** The language of the app: the user's choice, or the first supported language of the browser, or English. */

/** Languages by code, each with its own name. */
export const LANGUAGES = {
  en: 'English',
  de: 'Deutsch',
  es: 'Español',
  fr: 'Français',
  pt: 'Português',
  ja: '日本語',
};

export type Language = keyof typeof LANGUAGES;

const KEY = 'inkpanel.language';

/**
 * @param chosen the user's choice, if any
 * @param wanted the browser's languages in order of preference: `es-MX`
 */
export function pickLanguage(chosen: string | null, wanted: readonly string[]): Language {
  const codes = [chosen ?? '', ...wanted].map(languageOf);
  return (codes.find((code) => Object.hasOwn(LANGUAGES, code)) as Language | undefined) ?? 'en';
}

/**
 * The locale for numbers, dates and lists: the user's region, if the browser reports it.
 * @param wanted the browser's languages in order of preference
 */
export function localeOf(language: Language, wanted: readonly string[]): string {
  return wanted.find((tag) => languageOf(tag) === language) ?? language;
}

const languageOf = (tag: string) => tag.toLowerCase().split('-')[0];

/** The language of this visit. Without a document (in tests of parts) it is English. */
export function currentLanguage(): Language {
  if (typeof document === 'undefined') return 'en';
  return pickLanguage(remembered(), navigator.languages);
}

/** The browser's languages; in tests of parts none. */
export function browserLanguages(): readonly string[] {
  return typeof document === 'undefined' ? [] : navigator.languages;
}

/** Stores the choice for the next start, if the browser allows storage. */
export function rememberLanguage(language: Language) {
  try {
    window.localStorage.setItem(KEY, language);
  } catch {
    // Storage is refused: the browser's own languages decide.
  }
}

function remembered(): string | null {
  try {
    return window.localStorage.getItem(KEY);
  } catch {
    return null;
  }
}
