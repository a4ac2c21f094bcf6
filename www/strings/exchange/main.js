// @ts-check
/**
 * Implements `cargo xtask translations`: `node main.js export FOLDER [LANGUAGE]` and `node main.js import FILE`.
 * `docs/guide/translating.md` is the guide for translators.
 */

import { mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { catalogue, filesIn } from './catalogue.js';
import { exported, hasMoreForms, imported } from './po.js';
import { completeFolder } from './write.js';

const STRINGS = new URL('../', import.meta.url);
const folderOf = (/** @type {string} */ language) => new URL(`${language}/`, STRINGS);
const languages = () =>
  readdirSync(STRINGS, { withFileTypes: true })
    .filter((entry) => entry.isDirectory() && /^[a-z]{2,3}(-\w+)*$/.test(entry.name) && entry.name !== 'en')
    .map(({ name }) => name)
    .sort();

/** @param {string} folder @param {string[]} wanted */
function writeAll(folder, wanted) {
  const all = catalogue();
  mkdirSync(folder, { recursive: true });
  for (const language of wanted.length > 0 ? wanted : languages()) {
    const { text, missing, code } = exported(language, filesIn(folderOf(language)), all);
    const file = join(folder, `${language}.po`);
    writeFileSync(file, text);
    console.log(`${file}: ${all.messages.length - code.length} sentences, ${missing} of them not translated yet`);
    if (hasMoreForms(language)) console.log(`${language} counts in more than two forms: write these sentences by hand`);
    for (const context of code) console.log(`  by hand, as its translation is code: ${context}`);
  }
  console.log(`${all.code.length} sentences are code in English and translated by hand (docs/guide/translating.md):`);
  for (const context of all.code) console.log(`  ${context}`);
}

/** @param {string} file */
function readOne(file) {
  const all = catalogue();
  const before = new Map();
  const filesOf = (/** @type {string} */ language) => {
    for (const [name, text] of filesIn(folderOf(language))) before.set(name, text);
    return before;
  };
  const { language, files, changed, refused } = imported(readFileSync(file, 'utf8'), filesOf, all);
  const isNew = before.size === 0;
  if (isNew && changed > 0) completeFolder(files, all.sources);
  // All results are known before the first file is written, so that no partial result is left.
  if (changed > 0) mkdirSync(folderOf(language), { recursive: true });
  for (const [name, text] of files) {
    if (before.get(name) !== text) writeFileSync(new URL(`${name}.ts`, folderOf(language)), text);
  }
  console.log(`${language}: ${changed} sentences changed`);
  const index = files.get('index') ?? '';
  for (const name of files.keys()) {
    if (all.sources.has(name) && !/^(index|names|blocks)$/.test(name) && !index.includes(`'./${name}.ts'`)) {
      console.log(`name ${name}.ts in www/strings/${language}/index.ts`);
    }
  }
  if (isNew && changed > 0)
    console.log(`a new language: docs/guide/translating.md says where ${language} is named besides`);
  for (const why of refused) console.error(`not taken: ${why}`);
  if (refused.length > 0) process.exitCode = 1;
}

const [task, place, ...rest] = process.argv.slice(2);
if (task === 'export' && place) writeAll(place, rest);
else if (task === 'import' && place) readOne(place);
else throw new Error('export FOLDER [LANGUAGE...], or import FILE');
