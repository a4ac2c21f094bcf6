// @ts-check
/**
 * Compiles the message catalogues to TypeScript, in `compiled/`: a text without arguments becomes a string, and any other
 * message a function with named arguments. The browser therefore parses no messages. Vite runs this file as a
 * plugin; `node strings/compile.js` runs it for the type checker.
 */

import { mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { parse, TYPE } from '@formatjs/icu-messageformat-parser';

/** @typedef {import('@formatjs/icu-messageformat-parser').MessageFormatElement} Element */
/** @typedef {{ [key: string]: string | Catalogue }} Catalogue */
/** @typedef {Map<string, string>} Arguments name -> TypeScript type */
/** @typedef {{ code: string, given: Arguments }} Compiled */

const FOLDER = fileURLToPath(new URL('./', import.meta.url));
/** The language of the source texts: its arguments are the types of all languages, and missing texts appear in it. */
const SOURCE = 'en';
/** Catalogues of messages. `help` is loaded with the help dialog. */
const KINDS = ['messages', 'help'];
/** The app counts at most this many things, so a language needs the plural categories of these numbers only. */
const MAX_COUNT = 10_000;
/** @type {Map<string, Set<string>>} */
const categories = new Map();

/** @param {string} kind `messages`, `help` or `names` */
export const languagesOf = (kind) => readdirSync(`${FOLDER}${kind}/`).map((name) => name.replace('.json', ''));

/**
 * @param {string} kind
 * @param {string} language
 * @returns {Catalogue}
 */
export const catalogue = (kind, language) => JSON.parse(readFileSync(`${FOLDER}${kind}/${language}.json`, 'utf8'));

/**
 * @param {string} language
 * @returns {Set<string>} the plural categories of whole numbers that the app counts, and `other`
 */
export function categoriesOf(language) {
  const rules = new Intl.PluralRules(language);
  const found =
    categories.get(language) ?? new Set([...Array.from({ length: MAX_COUNT + 1 }, (_, n) => rules.select(n)), 'other']);
  categories.set(language, found);
  return found;
}

/**
 * @param {Catalogue} from
 * @returns {[string, string][]} the path of every message, and its text
 */
export function leaves(from, path = '') {
  return Object.entries(from).flatMap(([key, value]) =>
    typeof value === 'string'
      ? [/** @type {[string, string]} */ ([path + key, value])]
      : leaves(value, `${path}${key}.`),
  );
}

/**
 * @param {string} text in ICU MessageFormat
 * @param {string} language
 * @returns {Compiled} a TypeScript expression that reads its arguments from `a`
 * @throws if the message is not valid, or lacks a plural category of the language
 */
export function compileMessage(text, language) {
  /** @type {Arguments} */
  const given = new Map();
  /** @param {string} name @param {string} type */
  const take = (name, type) => {
    if (!/^[a-z]\w*$/i.test(name)) throw new Error(`{${name}} is not a valid name`);
    const known = given.get(name);
    if (known !== undefined && known !== type) throw new Error(`{${name}} is ${known} and ${type}`);
    given.set(name, type);
    return `a.${name}`;
  };

  /** @param {Record<string, { value: Element[] }>} options @param {string} [counted] */
  const branches = (options, counted) =>
    `{ ${Object.entries(options)
      .map(([name, { value }]) => `${JSON.stringify(name)}: ${template(value, counted)}`)
      .join(', ')} }`;

  /** @param {Element} element @param {string} [counted] @returns {string} a part of a template literal */
  function part(element, counted) {
    if (element.type === TYPE.literal) return element.value.replaceAll(/[\\`]|\$(?=\{)/g, '\\$&');
    if (element.type === TYPE.argument) return `\${${take(element.value, 'string')}}`;
    if (element.type === TYPE.pound) return `\${number(${counted})}`;
    if (element.type === TYPE.number) {
      const value = take(element.value, 'number');
      if (!element.style) return `\${number(${value})}`;
      const isPlain = typeof element.style === 'object' && element.style.parsedOptions.useGrouping === false;
      if (!isPlain) throw new Error(`{${element.value}}: the only number style is ::group-off`);
      return `\${${value}}`;
    }
    if (element.type === TYPE.select) {
      return `\${select(${take(element.value, 'string')}, ${branches(element.options, counted)})}`;
    }
    if (element.type === TYPE.plural && element.pluralType === 'cardinal' && element.offset === 0) {
      const missing = [...categoriesOf(language)].filter((category) => !(category in element.options));
      if (missing.length > 0) throw new Error(`{${element.value}} has no plural form ${missing.join(', ')}`);
      const value = take(element.value, 'number');
      return `\${plural(${value}, ${branches(element.options, value)})}`;
    }
    throw new Error('only plain arguments, number, plural and select are supported');
  }

  /** @param {Element[]} elements @param {string} [counted] */
  const template = (elements, counted) => `\`${elements.map((element) => part(element, counted)).join('')}\``;

  const code = template(parse(text, { ignoreTag: true, requiresOtherClause: true }), undefined);
  return { code, given };
}

/** @param {Arguments} given */
const typeOf = (given) => `{ ${[...given].map(([name, type]) => `${name}: ${type}`).join('; ')} }`;

/**
 * @param {string} language
 * @param {Catalogue} texts
 * @param {Catalogue} [source] texts of the source language, which replace missing texts; default: `texts` is the source
 * @returns {string} the fields of an object literal
 */
export function fields(language, texts, source, path = '') {
  const keys = new Set([...Object.keys(source ?? {}), ...Object.keys(texts)]);
  return [...keys]
    .map((key) => {
      const where = `${path}${key}`;
      const [text, original] = [texts[key], source?.[key]];
      const name = JSON.stringify(key);
      if (source && original === undefined) throw new Error(`${language}: ${where} is not a key of the source`);
      if (text !== undefined && original !== undefined && typeof text !== typeof original)
        throw new Error(`${language}: ${where} is a group in one language only`);
      if (typeof (text ?? original) === 'object') {
        const [group, from] = /** @type {Catalogue[]} */ ([text ?? {}, original]);
        return `${name}: {\n${fields(language, group, from, `${where}.`)}\n},`;
      }
      try {
        const { code, given } = compileMessage(String(text ?? original), text === undefined ? SOURCE : language);
        const wanted = original === undefined ? given : compileMessage(String(original), SOURCE).given;
        const unknown = [...given].filter(([argument, type]) => wanted.get(argument) !== type);
        if (unknown.length > 0) throw new Error(`the source has no ${typeOf(new Map(unknown))}`);
        if (wanted.size === 0) return `${name}: ${code},`;
        return `${name}: (${given.size === 0 ? '' : source ? 'a' : `a: ${typeOf(given)}`}) => ${code},`;
      } catch (error) {
        throw new Error(`${language}: ${where}: ${error instanceof Error ? error.message : error}`);
      }
    })
    .join('\n');
}

/**
 * @param {string} kind
 * @param {string} language
 * @returns {string} the name of the compiled module
 */
const moduleOf = (kind, language) => `${kind === 'messages' ? '' : `${kind}-`}${language}.ts`;

/**
 * @param {string} kind `messages` or `help`
 * @param {string} language
 * @returns {string} a module
 */
export function compileModule(kind, language) {
  const source = catalogue(kind, SOURCE);
  const head = `// Compiled from ${kind}/${language}.json by compile.js. Changes are lost.\n`;
  const types = "import type { Formats } from '../formats.ts';\n";
  const body = 'export const messages = ({ number, plural, select }: Formats)';
  if (language === SOURCE) {
    return `${head}${types}${body} => ({\n${fields(SOURCE, source)}\n});\nexport type Messages = ReturnType<typeof messages>;\n`;
  }
  const texts = fields(language, catalogue(kind, language), source);
  const same = `import type { Messages } from './${moduleOf(kind, SOURCE)}';\n`;
  const names = kind === 'messages' ? `export const names = ${JSON.stringify(catalogue('names', language))};\n` : '';
  return `${head}${types}${same}${body}: Messages => ({\n${texts}\n});\n${names}`;
}

/** Writes the modules that changed. */
export function compile() {
  const folder = `${FOLDER}compiled/`;
  mkdirSync(folder, { recursive: true });
  const modules = new Map(
    KINDS.flatMap((kind) =>
      languagesOf(kind).map((language) => [moduleOf(kind, language), compileModule(kind, language)]),
    ),
  );
  const old = readdirSync(folder);
  for (const name of old.filter((name) => !modules.has(name))) rmSync(folder + name);
  for (const [name, module] of modules) {
    if (!old.includes(name) || readFileSync(folder + name, 'utf8') !== module) writeFileSync(folder + name, module);
  }
}

/** @returns {import('vite').Plugin} */
export function messages() {
  return {
    name: 'inkpanel-messages',
    // Before anything resolves an import of a compiled module.
    configResolved: compile,
    configureServer({ watcher }) {
      watcher.add([...KINDS, 'names'].map((kind) => FOLDER + kind));
      watcher.on('change', (path) => void (/\/strings\/\w+\/[\w-]+\.json$/.test(path) && compile()));
    },
  };
}

if (process.argv[1] === fileURLToPath(import.meta.url)) compile();
