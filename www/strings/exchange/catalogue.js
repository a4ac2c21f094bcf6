// @ts-check
/** The strings to translate: texts of `strings/en`, and English names in the core and the data files. */

import { readFileSync, readdirSync } from 'node:fs';
import * as core from '../../pkg/inkpanel.js';
import { leavesOf, readSource, sentenceOf } from './source.js';

/** @typedef {import('./source.js').Source} Source */
/** @typedef {import('./source.js').Sentence} Sentence */

/**
 * Something to translate. `file` is without its ending; `key` begins with the name of the export.
 * @typedef {{ file: string, key: string[], context: string, english: Sentence, line: number | null, about: string }} Message
 */

/**
 * `code`: texts that only code can express. They are translated manually.
 * @typedef {{ messages: Message[], code: string[], sources: Map<string, Source> }} Catalogue
 */

/** Names in a language's `blocks.ts`, `layouts.ts`, `styles.ts` and `names.ts`. Their English source is elsewhere. */
const NAMED = /^(blocks\/|names\/names\/(choices|families)\/)/;

/**
 * @param {string | URL} folder of a language
 * @returns {Map<string, string>} its files by their names without extension; empty if the folder does not exist
 */
export function filesIn(folder) {
  const url = new URL(folder, import.meta.url);
  let names;
  try {
    names = readdirSync(url);
  } catch {
    return new Map();
  }
  const own = names.filter((name) => name.endsWith('.ts')).sort();
  return new Map(own.map((name) => [name.replace(/\.ts$/, ''), readFileSync(new URL(name, url), 'utf8')]));
}

/** @returns {Catalogue} */
export function catalogue() {
  /** @type {Catalogue} */
  const found = { messages: [], code: [], sources: new Map() };
  for (const [file, text] of filesIn('../en/')) {
    if (file === 'index') continue;
    const source = readSource(text, `${file}.ts`);
    found.sources.set(file, source);
    for (const { key, node } of leavesOf(source)) {
      const context = [file, ...key].join('/');
      if (NAMED.test(context)) continue;
      const english = sentenceOf(source, node);
      const line = text.slice(0, node.start).split('\n').length;
      if (!english) found.code.push(context);
      else if (english.many !== '') found.messages.push({ file, key, context, english, line, about: '' });
    }
  }
  found.messages.push(...named(found.sources));
  return found;
}

/**
 * The names of `Names`, as `naming` (`names.ts`) returns them without a translation.
 * @param {Map<string, Source>} sources
 * @returns {Message[]}
 */
function named(sources) {
  core.initSync({ module: readFileSync(new URL('../../pkg/inkpanel_bg.wasm', import.meta.url)) });
  const [blocks, layouts, styles] = [core.blocks(), core.layouts(), core.styles()].map((told) => JSON.parse(told));
  const own = new Map(
    ['blocks', 'names'].flatMap((file) => {
      const source = sources.get(file);
      return source ? leavesOf(source).map(({ key, node }) => [[file, ...key].join('/'), node.value]) : [];
    }),
  );
  /** @type {Map<string, Message>} */
  const messages = new Map();
  /** @type {(file: string, key: string[], text: string | undefined, about: string) => void} */
  const add = (file, key, text, about) => {
    const context = [file, ...key].join('/');
    const told = own.get(context) ?? text;
    if (!told) return;
    const english = { one: told, many: told, holes: [], count: null, condition: null, parameters: null, literal: true };
    messages.set(context, { file, key, context, english, line: null, about });
  };
  const asName = (/** @type {string} */ id) => id.charAt(0).toUpperCase() + id.slice(1).replaceAll(/[-_]/g, ' ');
  for (const { id, name } of styles) add('styles', ['styles', id], name, 'Name of a style');
  for (const { id, name } of layouts) add('layouts', ['layouts', id], name, 'Name of a layout');
  for (const { id, label, help, params } of blocks) {
    add(
      'blocks',
      ['blocks', id, '0'],
      label,
      'A plain name of a filter block, the term of the field behind it in brackets',
    );
    add('blocks', ['blocks', id, '1'], help, 'What the filter block does');
    for (const param of params) {
      add('blocks', ['parameters', `${id}.${param.id}`, '0'], param.label, 'Name of a setting of the filter block');
      add('blocks', ['parameters', `${id}.${param.id}`, '1'], param.help, 'What the setting does');
      for (const choice of param.choices ?? []) {
        add(
          'names',
          ['names', 'choices', choice],
          asName(choice),
          `A choice of the setting ${param.label} of ${label}`,
        );
      }
    }
  }
  for (const { family } of layouts) add('names', ['names', 'families', family], asName(family), 'A family of layouts');
  for (const tag of styles.flatMap((/** @type {{ tags: string[] }} */ { tags }) => tags)) {
    add('names', ['names', 'families', tag], asName(tag), 'A kind of styles');
  }
  return [...messages.values()];
}
