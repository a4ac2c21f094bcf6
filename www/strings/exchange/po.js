// @ts-check
/** A language as a PO file of gettext, which translators' tools read, and back. */

import { po } from 'gettext-parser';
import { leavesOf, readSource, sentenceOf } from './source.js';
import { put, quoted, template } from './write.js';

/** @typedef {import('./source.js').Sentence} Sentence */
/** @typedef {import('./source.js').Source} Source */
/** @typedef {import('./catalogue.js').Catalogue} Catalogue */
/** @typedef {import('./catalogue.js').Message} Message */

/** @typedef {Map<string, string>} Files the files of a language by their names without ending */

const HOLE = /\{([^{}]*)\}/g;

/** @param {string} language a tag such as `pt` or `zh-Hant` */
const formsOf = (language) => {
  const rules = new Intl.PluralRules(language);
  const { pluralCategories } = rules.resolvedOptions();
  // Counts in the app are too small for the plural form of millions (`many` in French).
  const small = new Set(Array.from({ length: 1000 }, (_, n) => rules.select(n)));
  return {
    count: Math.max(1, small.size),
    categories: pluralCategories,
    zeroIsOne: rules.select(0) === rules.select(1),
  };
};

/**
 * How many forms of a counted sentence a language is written with here: one or two.
 * @param {string} language
 */
export function pluralForms(language) {
  const { count, zeroIsOne } = formsOf(language);
  if (count === 1) return { forms: 1, header: 'nplurals=1; plural=0;', condition: '' };
  // French treats 0 as singular. Languages with three or more forms are translated manually.
  return zeroIsOne
    ? { forms: 2, header: 'nplurals=2; plural=(n > 1);', condition: '< 2' }
    : { forms: 2, header: 'nplurals=2; plural=(n != 1);', condition: '=== 1' };
}

/**
 * @param {string} language
 * @returns whether its counted sentences have more forms than can be written in such a file
 */
export const hasMoreForms = (language) => formsOf(language).count > 2;

/**
 * @param {Files} files
 * @returns {Map<string, { source: Source, node: import('./source.js').Node }>} every sentence by its context
 */
function sentencesIn(files) {
  const found = new Map();
  for (const [file, text] of files) {
    if (file === 'index') continue;
    const source = readSource(text, `${file}.ts`);
    for (const { key, node } of leavesOf(source)) found.set([file, ...key].join('/'), { source, node });
  }
  return found;
}

/**
 * @param {Sentence} english
 * @param {Sentence | null} other
 * @param {number} forms
 * @returns {string[] | null} the translation next to the English text; null if it needs code
 */
function beside(english, other, forms) {
  if (!other || english.literal !== other.literal || (other.count !== null && other.count !== english.count))
    return null;
  const places = [...english.holes, english.count];
  if (other.holes.some((hole) => !places.includes(hole))) return null;
  if (english.count === null || forms === 1) return other.one === other.many ? [other.many] : null;
  return [other.one, other.many];
}

/**
 * @param {string} language
 * @param {Files} files its current files
 * @param {Catalogue} catalogue
 * @returns {{ text: string, missing: number, code: string[] }} `code`: texts that are code here, but not in English
 */
export function exported(language, files, { messages }) {
  const { forms, header } = pluralForms(language);
  const there = sentencesIn(files);
  /** @type {Record<string, Record<string, import('gettext-parser').GetTextTranslation>>} */
  const translations = {};
  /** @type {string[]} */
  const code = [];
  let missing = 0;
  for (const { context, english, file, line, about } of messages) {
    const found = there.get(context);
    const told = found ? beside(english, sentenceOf(found.source, found.node), forms) : [];
    if (!told) {
      code.push(context);
      continue;
    }
    if (told.length === 0) missing += 1;
    const places = [...new Set([...english.holes, ...(english.count ? [english.count] : [])])];
    const notes = [about, ...(places.length > 0 ? [`Put in: ${places.map((hole) => `{${hole}}`).join(', ')}`] : [])];
    const extracted = notes.filter(Boolean).join('\n');
    translations[context] = {
      [english.one]: {
        msgctxt: context,
        msgid: english.one,
        ...(english.count !== null && { msgid_plural: english.many }),
        msgstr: told.length > 0 ? told : english.count === null ? [''] : Array(forms).fill(''),
        comments: {
          ...(line !== null && { reference: `www/strings/en/${file}.ts:${line}` }),
          ...(extracted && { extracted }),
          // Tools then see to it that no place is lost.
          ...(places.length > 0 && { flag: 'python-brace-format' }),
        },
      },
    };
  }
  const headers = {
    'Project-Id-Version': 'inkpanel',
    Language: language,
    'MIME-Version': '1.0',
    'Content-Type': 'text/plain; charset=utf-8',
    'Content-Transfer-Encoding': '8bit',
    'Plural-Forms': header,
  };
  const text = po.compile({ charset: 'utf-8', headers, translations }, { foldLength: 0 }).toString('utf8');
  return { text: text.endsWith('\n') ? text : `${text}\n`, missing, code };
}

/**
 * Updates the files of a language from a PO file. Texts that are empty in the PO file do not change.
 * @param {string} text of the PO file
 * @param {(language: string) => Files} filesOf current files of a language
 * @param {Catalogue} catalogue
 * @returns {{ language: string, files: Files, changed: number, refused: string[] }} `refused`: rejected texts, and the
 * reasons
 */
export function imported(text, filesOf, catalogue) {
  const { headers, translations } = po.parse(text);
  const language = Object.entries(headers).find(([name]) => name.toLowerCase() === 'language')?.[1] ?? '';
  if (!/^[a-z]{2,3}(-[A-Za-z0-9]+)*$/.test(language) || language === 'en') {
    throw new Error(
      `the header Language says ${JSON.stringify(language)}: it should be a tag such as "nl", and not English`,
    );
  }
  const files = new Map(filesOf(language));
  const { forms, condition } = pluralForms(language);
  const known = new Map(catalogue.messages.map((message) => [message.context, message]));
  const there = sentencesIn(files);
  /** @type {string[]} */
  const refused = [];
  let changed = 0;
  const entries = Object.values(translations)
    .flatMap((entries) => Object.values(entries))
    .filter(({ msgid }) => msgid !== '');
  // Texts that refer to controls of other areas come last, after these areas exist.
  const late = (/** @type {string | undefined} */ context) =>
    Number(known.get(context ?? '')?.english.holes.some((hole) => hole.includes('.')) ?? false);
  entries.sort((a, b) => late(a.msgctxt) - late(b.msgctxt));
  for (const { msgctxt = '', msgid, msgid_plural, msgstr, comments } of entries) {
    const message = known.get(msgctxt);
    if (msgstr.every((form) => form === '')) continue;
    const say = (/** @type {string} */ why) => refused.push(`${msgctxt || JSON.stringify(msgid)}: ${why}`);
    if (!message) {
      say('there is no such sentence, or only code can tell it');
      continue;
    }
    const { english } = message;
    if (msgid !== english.one || (english.count !== null && msgid_plural !== english.many)) {
      say(`the English is another now: ${JSON.stringify(english.many)}`);
      continue;
    }
    if (comments?.flag?.includes('fuzzy')) {
      say('it is marked as fuzzy');
      continue;
    }
    const found = there.get(msgctxt);
    const before = found && sentenceOf(found.source, found.node);
    const told = found && beside(english, before ?? null, forms);
    if (told && told.length === msgstr.length && told.every((form, at) => form === msgstr[at])) continue;
    const wrong = found && !told ? 'its translation is code: change it by hand' : mistakes(english, msgstr, forms);
    if (wrong) {
      say(wrong);
      continue;
    }
    const parameters = before?.parameters ?? english.parameters;
    const code = codeOf(english, msgstr, parameters, before?.condition ?? condition);
    const error = put(files, message, code, catalogue.sources);
    if (error) say(error);
    else changed += 1;
  }
  return { language, files, changed, refused };
}

/**
 * @param {Sentence} english
 * @param {string[]} told
 * @param {number} forms
 * @returns the errors of a translation
 */
function mistakes(english, told, forms) {
  if (told.length !== (english.count === null ? 1 : forms)) return `it has ${told.length} forms`;
  if (told.some((form) => form === '')) return 'one of its forms is empty';
  if (english.literal) return '';
  const places = [...new Set([...english.holes, ...(english.count ? [english.count] : [])])];
  for (const form of told) {
    const strange = [...form.matchAll(HOLE)].find(([, hole]) => !places.includes(hole));
    if (strange) return `nothing is called ${strange[0]}: there is ${places.map((hole) => `{${hole}}`).join(', ')}`;
    if (/[{}]/.test(form.replaceAll(HOLE, ''))) return 'a bracket { or } stands alone';
  }
  const needed = [...english.many.matchAll(HOLE)].map(([place]) => place);
  const lost = needed.find((place) => !told[told.length - 1].includes(place));
  return lost ? `${lost} is lost` : '';
}

/**
 * @param {Sentence} english
 * @param {string[]} told
 * @param {string | null} parameters with their types; null if it is not a function
 * @param {string} condition selects the singular
 */
function codeOf(english, told, parameters, condition) {
  if (english.literal) return quoted(told[0]);
  const [one, many] = [told[0], told[told.length - 1]].map(template);
  const body = one === many ? many : `${english.count} ${condition} ? ${one} : ${many}`;
  return parameters === null ? body : `${parameters} => ${body}`;
}
