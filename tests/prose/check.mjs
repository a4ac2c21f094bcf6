#!/usr/bin/env node
/**
 * Counts unclear English per file and fails if a count rises: `cargo xtask test prose`.
 *
 *     node tests/prose/check.mjs              compares all files with the baseline
 *     node tests/prose/check.mjs FILE...      lists every hit in these files
 *     node tests/prose/check.mjs --lower      stores counts that fell
 *     node tests/prose/check.mjs --record     stores all counts; only after a merge, with a reviewer
 *
 * `rules.mjs` has the patterns, `baseline.json` the allowed count of each file. A file without an entry may have 3 hits per 1,000 words.
 */

import { execFileSync } from 'node:child_process';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { LABEL, prose, sentences, words } from './extract.mjs';
import { LONGEST, RULES } from './rules.mjs';

const ROOT = join(dirname(fileURLToPath(import.meta.url)), '../..');
const BASELINE = 'tests/prose/baseline.json';
/** Hits per 1,000 words in a file without an entry in the baseline. */
const RATE = 3;
/** Longest commit subject in characters. */
const SUBJECT = 72;
const KINDS = /\.(?:md|rs|ts|tsx|js|mjs|css|py|toml|sh|yml)$|^www\/strings\/(?:messages|help)\/en\.json$/;
/** Generated files, other people's texts, and the rules with their bad examples. */
const SKIPPED =
  /(?:^|\/)(?:node_modules|target|dist|pkg[\w-]*|vendor)\/|^www\/engine\/types(?:-written)?\.ts$|^www\/strings\/compiled\/|^tests\/prose\/rules\.mjs$/;

/** @typedef {{ line: number, id: string, advice: string, text: string }} Hit */

const git = (/** @type {string[]} */ ...args) =>
  execFileSync('git', args, { cwd: ROOT, encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'], maxBuffer: 1 << 26 });

/** Paths of all text files, tracked or new. Without git, every file below the top folder. */
function files() {
  try {
    const listed = git('ls-files', '-z', '--cached', '--others', '--exclude-standard').split('\0');
    return listed.filter((path) => KINDS.test(path) && !SKIPPED.test(path)).sort();
  } catch {
    const all = readdirSync(ROOT, { recursive: true, encoding: 'utf8' }).map((path) => path.replaceAll('\\', '/'));
    return all.filter((path) => KINDS.test(path) && !SKIPPED.test(path) && !/(?:^|\/)\.git\//.test(path)).sort();
  }
}

/**
 * @param {string} text one sentence
 * @param {number} line
 * @param {number} longest in words
 * @returns {Hit[]}
 */
function judge(text, line, longest) {
  const hits = RULES.filter((rule) => rule.find.test(text)).map(({ id, advice }) => ({ line, id, advice, text }));
  const count = words(text);
  if (count > longest) hits.push({ line, id: 'length', advice: `${count} words: split it, at most ${longest}`, text });
  return hits;
}

/**
 * @param {string} path
 * @returns {{ hits: Hit[], count: number }} the hits in a file, and its number of words; null if the file was deleted
 */
function read(path) {
  let text = '';
  try {
    text = readFileSync(join(ROOT, path), 'utf8');
  } catch {
    return { hits: [], count: 0 };
  }
  const blocks = prose(path, text);
  const longest = path.endsWith('.md') ? LONGEST.markdown : LONGEST.other;
  const found = blocks.flatMap(sentences);
  return {
    hits: found.flatMap(({ text, line, isList }) => judge(text, line, isList ? Number.POSITIVE_INFINITY : longest)),
    count: found.reduce((sum, { text }) => sum + words(text), 0),
  };
}

const show = (/** @type {string} */ path, /** @type {Hit} */ { line, id, advice, text }) =>
  `  ${path}:${line}: ${id}: ${advice}\n      ${text.length > 160 ? `${text.slice(0, 157)}...` : text}`;

/** @returns {string[]} rules that miss their bad example or find their good one */
function brokenRules() {
  return RULES.flatMap(({ id, find, bad, good }) => [
    ...(find.test(bad) ? [] : [`rules.mjs: ${id} does not find "${bad}"`]),
    ...RULES.filter((rule) => rule.find.test(good)).map((rule) => `rules.mjs: ${rule.id} finds "${good}"`),
  ]);
}

/**
 * @param {string} since
 * @returns {string[]} commit subjects that break a rule
 */
function brokenSubjects(since) {
  let log = '';
  try {
    git('cat-file', '-e', `${since}^{commit}`);
    log = git('log', '--no-merges', '--format=%h %s', `${since}..HEAD`);
  } catch {
    console.log('commit subjects: skipped, as this clone does not have the commit of the baseline');
    return [];
  }
  const subjects = log.split('\n').filter((line) => line !== '');
  console.log(`commit subjects: ${subjects.length} checked`);
  return subjects.flatMap((line) => {
    const [, hash, subject] = /^(\S+) (.*)$/.exec(line) ?? ['', '', line];
    const hits = judge(subject.replace(/^[\w /-]+: /, ''), 0, LONGEST.markdown).map(
      ({ id, advice }) => `${id}: ${advice}`,
    );
    if (subject.length > SUBJECT) hits.push(`length: ${subject.length} characters, at most ${SUBJECT}`);
    return hits.map((hit) => `  commit ${hash}: ${hit}\n      ${subject}`);
  });
}

const total = (/** @type {Record<string, number>} */ counts) =>
  Object.values(counts).reduce((sum, count) => sum + count, 0);

/**
 * @param {string} since
 * @param {Record<string, number>} counts
 * @returns {string[]} commits since then whose baseline has a lower total
 */
function raised(since, counts) {
  try {
    const commits = git('log', '--format=%h', `${since}..HEAD`, '--', BASELINE).split('\n').filter(Boolean);
    return commits.flatMap((commit) => {
      const before = total(JSON.parse(git('show', `${commit}:${BASELINE}`)).files);
      return before < total(counts)
        ? [`  ${BASELINE}: commit ${commit} allows ${before} hits in all, now ${total(counts)}`]
        : [];
    });
  } catch {
    return [];
  }
}

/** @returns {string[]} controls that a guide prints in bold and the interface does not have */
function unknownLabels() {
  const catalogues = ['messages', 'names'].map((kind) => join(ROOT, `www/strings/${kind}/en.json`));
  const strings = catalogues.map((file) => readFileSync(file, 'utf8')).join('\n');
  const known = (/** @type {string} */ label) =>
    [`: ${JSON.stringify(label)}`, `{${label}}`].some((text) => strings.includes(text));
  const guides = files().filter((path) => /^docs\/guide\/[\w-]+\.md$/.test(path));
  return guides.flatMap((path) => {
    const labels = [...readFileSync(join(ROOT, path), 'utf8').matchAll(LABEL)].map((match) => match[1]);
    return labels
      .filter((label) => !known(label))
      .map((label) => `  ${path}: **${label}** is not in an en.json of www/strings/`);
  });
}

const store = (/** @type {string} */ since, /** @type {Record<string, number>} */ counts) => {
  const sorted = Object.fromEntries(
    Object.entries(counts)
      .filter(([, count]) => count > 0)
      .sort(([a], [b]) => (a < b ? -1 : 1)),
  );
  writeFileSync(join(ROOT, BASELINE), `${JSON.stringify({ since, files: sorted }, null, 2)}\n`);
  console.log(`${BASELINE}: ${total(sorted)} hits in ${Object.keys(sorted).length} files`);
};

function main() {
  const args = process.argv.slice(2);
  const named = args.filter((arg) => !arg.startsWith('--'));
  if (named.length > 0) {
    for (const path of named) {
      const { hits, count } = read(path);
      console.log(hits.map((hit) => show(path, hit)).join('\n'));
      console.log(`${path}: ${hits.length} hits in ${count} words`);
    }
    return 0;
  }
  const found = new Map(files().map((path) => [path, read(path)]));
  if (args.includes('--record')) {
    store(
      git('rev-parse', 'HEAD').trim(),
      Object.fromEntries([...found].map(([path, { hits }]) => [path, hits.length])),
    );
    return 0;
  }
  /** @type {{ since: string, files: Record<string, number> }} */
  const baseline = JSON.parse(readFileSync(join(ROOT, BASELINE), 'utf8'));
  const allowed = (/** @type {string} */ path, /** @type {number} */ count) =>
    baseline.files[path] ?? Math.floor((RATE * count) / 1000);
  const worse = [...found].filter(([path, { hits, count }]) => hits.length > allowed(path, count));
  if (args.includes('--lower')) return lower(baseline, found, worse);

  const problems = worse.flatMap(([path, { hits, count }]) => [
    `${path}: ${hits.length} hits, at most ${allowed(path, count)} allowed`,
    ...hits.slice(0, 20).map((hit) => show(path, hit)),
  ]);
  problems.push(
    ...brokenRules(),
    ...raised(baseline.since, baseline.files),
    ...unknownLabels(),
    ...brokenSubjects(baseline.since),
  );
  const worst = [...found]
    .filter(([, { hits }]) => hits.length > 0)
    .sort(([, a], [, b]) => b.hits.length - a.hits.length);
  const sum = worst.reduce((sum, [, { hits }]) => sum + hits.length, 0);
  console.log(`${sum} hits in ${worst.length} of ${found.size} files; the worst:`);
  for (const [path, { hits, count }] of worst.slice(0, 5))
    console.log(`  ${path}: ${hits.length} hits in ${count} words`);
  const falls = Object.entries(baseline.files).filter(
    ([path, count]) => (found.get(path)?.hits.length ?? 0) < count,
  ).length;
  if (falls > 0)
    console.log(`${falls} files have fewer hits than allowed: store that with node tests/prose/check.mjs --lower`);
  if (problems.length === 0) return 0;
  console.error(`\n${problems.join('\n')}`);
  console.error(
    '\nRewrite these sentences: name the thing with its standard noun, make it the subject, and say what it does.' +
      '\nCONTRIBUTING.md, "Plain English", has the rules. Counts in the baseline may only fall.',
  );
  return 1;
}

/**
 * Stores lower counts. A moved file takes its count along: new files share the hits of files that are gone.
 *
 * @param {{ since: string, files: Record<string, number> }} baseline
 * @param {Map<string, { hits: Hit[], count: number }>} found
 * @param {[string, { hits: Hit[], count: number }][]} worse
 */
function lower(baseline, found, worse) {
  const risen = worse.filter(([path]) => path in baseline.files);
  const moved = worse.filter(([path]) => !(path in baseline.files));
  const gone = Object.entries(baseline.files).filter(([path]) => !found.has(path));
  const free = gone.reduce((sum, [, count]) => sum + count, 0);
  const needed = moved.reduce((sum, [, { hits }]) => sum + hits.length, 0);
  if (risen.length > 0 || needed > free) {
    console.error(`not stored: ${risen.length} counts rose; new files have ${needed} hits, deleted files had ${free}`);
    return 1;
  }
  const left = Object.entries(baseline.files).filter(([path]) => found.has(path));
  const now = left.map(([path]) => [path, found.get(path)?.hits.length ?? 0]);
  store(baseline.since, Object.fromEntries([...now, ...moved.map(([path, { hits }]) => [path, hits.length])]));
  return 0;
}

process.exitCode = main();
