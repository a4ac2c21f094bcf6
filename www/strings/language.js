// @ts-check
/** Which language the page speaks: the person's choice, else the browser's first that there is, else English. */

/** Languages by code, each in its own words. */
export const LANGUAGES = { en: 'English', es: 'Español' };

/** @typedef {keyof typeof LANGUAGES} Language */

const KEY = 'inkpanel.language';

/**
 * @param {string | null} chosen by the person, if ever
 * @param {readonly string[]} wanted the browser's languages, the best first: `es-MX`
 * @returns {Language}
 */
export function pickLanguage(chosen, wanted) {
  const codes = [chosen ?? '', ...wanted].map((tag) => tag.toLowerCase().split('-')[0]);
  return /** @type {Language | undefined} */ (codes.find((code) => Object.hasOwn(LANGUAGES, code))) ?? 'en';
}

/** The language of this visit. Without a document (in tests of parts) it is English. @returns {Language} */
export function currentLanguage() {
  if (typeof document === 'undefined') return 'en';
  return pickLanguage(remembered(), navigator.languages);
}

/** Keeps the choice for the next load; where the browser keeps nothing it is lost. @param {Language} language */
export function rememberLanguage(language) {
  try {
    window.localStorage.setItem(KEY, language);
  } catch {
    // Storage is refused: the browser's own languages decide.
  }
}

/** @returns {string | null} */
function remembered() {
  try {
    return window.localStorage.getItem(KEY);
  } catch {
    return null;
  }
}
