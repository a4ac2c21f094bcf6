// @ts-check
/**
 * Generator of malformed project files and page PNGs. A seed decides how the good document is damaged: other types, missing or
 * repeated fields, and numbers, texts and counts out of range. The file itself may be damaged too.
 */

import { readFileSync } from 'node:fs';
import { pngOf, chunkOf, textChunk, withChunks } from '../../../www/engine/png-chunks.ts';
import { archiveOf } from '../../../www/engine/archive.ts';
import { expanded, recordIn } from '../../../www/engine/interned.ts';
import { withProject } from '../../../www/storage/files/page-file.ts';

/** @typedef {{ name: string, blob: Blob }} Entry */
/** `what`: the damage. @typedef {{ seed: number, name: string, bytes: Buffer, what: string }} Malformed */
/** @typedef {{ next: () => number, below: (n: number) => number, of: <T>(list: readonly T[]) => T }} Chance */

/** @param {number} seed @returns {Chance} the same numbers for the same seed (mulberry32) */
function chanceOf(seed) {
  let state = seed >>> 0;
  const next = () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
  const below = (/** @type {number} */ n) => Math.floor(next() * n);
  return { next, below, of: (list) => list[below(list.length)] };
}

const STYLE = {
  id: 'mine',
  name: 'Mine',
  tags: ['ink'],
  background: [
    { block: 'posterize', levels: 4 },
    { block: 'to_gray', bypass: true },
  ],
  foreground: [{ block: 'to_gray' }, { block: 'xdog' }],
  ink: '#203050',
};
const LAYOUTS = new URL('../../../layouts/', import.meta.url);

const LONG = 100_000;
/** Maximum number of characters that one change adds. `traps.spec.js` tests larger files. */
const MOST_TEXT = 2_000_000;
const NUMBERS = [
  -1,
  0,
  0.5,
  1,
  1.5,
  10.5,
  101,
  255.5,
  1e6,
  2 ** 31,
  2 ** 32,
  2 ** 53,
  -(2 ** 53),
  1e-300,
  1e308,
  -1e308,
];
const TEXTS = [
  '',
  ' ',
  '\ud800',
  '\udc00\ud800',
  'x\ud83d',
  '\0',
  '\u202e\u0000\ufeff',
  '__proto__',
  'constructor',
  '<img src=x onerror=alert(1)>',
  '../../etc/passwd',
  '#12345',
  '#ffffff00',
  'NaN',
  '-1',
  '💥'.repeat(50),
  'a\u0301'.repeat(500),
  'y'.repeat(LONG),
];
const OTHERS = [
  null,
  true,
  false,
  [],
  {},
  [null],
  [[]],
  [{}],
  { length: 1e9 },
  { toString: 1, id: 7 },
  [[[[[[[[1]]]]]]]],
  'text',
  7,
  JSON.parse('{"__proto__": {"tray": 5}, "constructor": {"prototype": 1}}'),
];

/** @param {unknown} value @param {number} depth @returns {any} lists inside of each other */
const nested = (value, depth) => Array.from({ length: depth }).reduce((/** @type {any} */ inner) => [inner], value);

/** All places of a document. @param {any} document */
function placesIn(document) {
  /** @type {{ parent: any, key: string | number, path: string }[]} */
  const places = [];
  const walk = (/** @type {any} */ value, /** @type {string} */ path) => {
    if (typeof value !== 'object' || value === null) return;
    for (const key of Object.keys(value)) {
      places.push({ parent: value, key, path: `${path}.${key}` });
      walk(value[key], `${path}.${key}`);
    }
  };
  walk(document, '');
  return places;
}

/** Changes of one place. @type {Record<string, (chance: Chance, place: { parent: any, key: any }, document: any) => void>} */
const DEEDS = {
  swap: (chance, { parent, key }) => {
    parent[key] = structuredClone(chance.of([...OTHERS, ...NUMBERS, ...TEXTS]));
  },
  drop: (_, { parent, key }) => {
    if (Array.isArray(parent)) parent.splice(Number(key), 1);
    else delete parent[key];
  },
  number: (chance, { parent, key }) => {
    parent[key] =
      typeof parent[key] === 'number' && chance.next() < 0.4
        ? -parent[key] * chance.of([1, 10, 1000])
        : chance.of(NUMBERS);
  },
  text: (chance, { parent, key }) => {
    parent[key] = chance.next() < 0.3 ? `${parent[key]}${chance.of(TEXTS)}` : chance.of(TEXTS);
  },
  count: (chance, { parent, key }) => {
    // Clones: a later change of a shared copy would add its text to all copies.
    const value = parent[key];
    const few = Math.ceil(MOST_TEXT / (1 + JSON.stringify(value ?? null).length));
    if (Array.isArray(value) && value.length > 0)
      parent[key] = Array.from({ length: Math.min(few * value.length, chance.of([2, 200, 1000, 6000])) }, (_, i) =>
        structuredClone(value[i % value.length]),
      );
    else parent[key] = Array.from({ length: Math.min(few, chance.of([1, 201, 5001])) }, () => structuredClone(value));
  },
  deepen: (chance, { parent, key }) => {
    parent[key] = nested(parent[key], chance.of([1, 2, 100, 1000]));
  },
  double: (_, { parent, key }) => {
    if (Array.isArray(parent)) parent.push(parent[key]);
    else parent[`${key}2`] = parent[key];
  },
  move: (chance, place, document) => {
    const other = chance.of(placesIn(document));
    other.parent[other.key] = structuredClone(place.parent[place.key]);
  },
};

/**
 * @param {Chance} chance
 * @param {any} good
 * @returns {{ text: string, what: string }} another document, as JSON
 */
function spoiltDocument(chance, good) {
  const document = structuredClone(good);
  /** @type {string[]} */
  const what = [];
  for (let left = chance.of([1, 1, 1, 2, 3, 5]); left > 0; left -= 1) {
    const places = placesIn(document);
    if (places.length === 0) break;
    // Most places are deep in a page or a style; each depth has its turn.
    const level = chance.below(8);
    const near = places.filter(({ path }) => path.split('.').length - 2 === level);
    const place = chance.of(near.length > 0 ? near : places);
    const deed = chance.of(Object.keys(DEEDS));
    DEEDS[deed](chance, place, document);
    what.push(`${deed} ${place.path}`);
  }
  let text = JSON.stringify(document);
  if (chance.next() < 0.12) {
    const [deed, change] = chance.of(TEXT_DEEDS);
    text = change(chance, text);
    what.push(deed);
  }
  return { text, what: what.join(', ') };
}

/** Changes of the text. @type {[string, (chance: Chance, text: string) => string][]} */
const TEXT_DEEDS = [
  ['cut', (chance, text) => text.slice(0, chance.below(text.length))],
  [
    'a sign changed',
    (chance, text) => {
      const at = chance.below(text.length);
      return `${text.slice(0, at)}${chance.of(['{', '}', '[', ']', '"', '\\', '0', '-', '\u0000', ','])}${text.slice(at + 1)}`;
    },
  ],
  ['a key twice', (_, text) => text.replace('"version"', '"version":1,"history":null,"version"')],
  ['a number of thousands of digits', (_, text) => text.replace(/:(\d+)/, `:${'9'.repeat(4000)}`)],
  ['brackets', (_, text) => text.replace('"photos":', `"more":${'['.repeat(20_000)}${']'.repeat(20_000)},"photos":`)],
  ['a mark before it', (_, text) => `\ufeff${text}`],
  ['something behind it', (_, text) => `${text}{}`],
];

/** @param {Chance} chance @param {Buffer} bytes */
function spoiltBytes(chance, bytes) {
  const other = Buffer.from(bytes);
  const kind = chance.below(3);
  if (kind === 0) return { bytes: other.subarray(0, chance.below(other.length)), what: 'cut short' };
  for (let left = kind === 1 ? 1 : 20; left > 0; left -= 1) other[chance.below(other.length)] ^= 1 << chance.below(8);
  return { bytes: other, what: 'bits changed' };
}

/** @param {{ document: any, photos: Entry[] }} good @returns {Promise<Malformed>} the file with nothing spoilt */
export async function soundProject({ document, photos }) {
  const archive = await archiveOf([{ name: 'project.json', blob: new Blob([JSON.stringify(document)]) }, ...photos]);
  return { seed: 0, name: 'sound.inkpanel', bytes: await bytesOf(archive), what: 'nothing' };
}

/** @param {{ document: any, photos: Entry[] }} good @returns {Promise<Malformed>} the same, of a page */
export async function soundPage({ document, photos }) {
  return {
    seed: 0,
    name: 'sound.png',
    bytes: await bytesOf(await withProject(await barePng(), JSON.stringify(document), photos)),
    what: 'nothing',
  };
}

/** Its pixels are never looked at. */
async function barePng() {
  return pngOf([
    await chunkOf('IHDR', new Uint8Array(13)),
    await chunkOf('IDAT', new Uint8Array(9)),
    await chunkOf('IEND', new Uint8Array(0)),
  ]);
}

/** @param {Blob} blob */
const bytesOf = async (blob) => Buffer.from(await blob.arrayBuffer());

/**
 * @param {number} seed
 * @param {{ document: any, photos: Entry[] }} good
 * @returns {Promise<Malformed>} a project file
 */
export async function malformedProject(seed, { document, photos }) {
  const chance = chanceOf(seed);
  const { text, what } = spoiltDocument(chance, document);
  const entries = [{ name: 'project.json', blob: new Blob([text]) }, ...photos];
  if (chance.next() < 0.1) entries.splice(1 + chance.below(photos.length), 1);
  let bytes = await bytesOf(await archiveOf(entries));
  const spoilt = chance.next() < 0.1 ? spoiltBytes(chance, bytes) : null;
  if (spoilt) ({ bytes } = spoilt);
  return { seed, name: `project-${seed}.inkpanel`, bytes, what: [what, spoilt?.what].filter(Boolean).join(', ') };
}

/**
 * @param {number} seed
 * @param {{ document: any, photos: Entry[] }} good
 * @returns {Promise<Malformed>} a PNG that carries a page
 */
export async function malformedPage(seed, { document, photos }) {
  const chance = chanceOf(seed ^ 0x5bd1e995);
  const { text, what } = spoiltDocument(chance, document);
  const more = [what];
  let png = await withProject(await barePng(), text, chance.next() < 0.5 ? photos : []);
  if (chance.next() < 0.05) {
    png = await withChunks(png, { before: [await textChunk('inkpanel', text.slice(0, chance.below(text.length)))] });
    more.push('two texts');
  }
  let bytes = await bytesOf(png);
  if (chance.next() < 0.08) {
    const spoilt = spoiltBytes(chance, bytes);
    bytes = spoilt.bytes;
    more.push(spoilt.what);
  }
  return { seed, name: `page-${seed}.png`, bytes, what: more.join(', ') };
}

/** Adds text items, a custom style, a draft and a crop, which tests can damage. @param {any} document */
export function enriched(document) {
  const { present } = document.history;
  present.name = 'Malformed';
  present.ownLayouts = [{ ...JSON.parse(readFileSync(new URL('cinema-3.json', LAYOUTS), 'utf8')), id: 'own' }];
  present.mine = [STYLE];
  present.favourites = [{ ...STYLE, id: 'loved' }];
  present.page.words = [
    { kind: 'caption', text: 'Meanwhile', panel: 0, auto: true },
    {
      kind: 'balloon',
      text: 'HO',
      shape: 'shout',
      panel: 0,
      x: 0.4,
      y: 0.3,
      width: 0.2,
      size: 0.03,
      tail: { x: 0.6, y: 0.6 },
      font: 'comic-neue',
      color: '#111111',
      fill: '#ffffff',
      auto: false,
    },
    { kind: 'effect', text: 'BAM', panel: null, x: 0.5, y: 0.5, angle: -8, arc: 0.2, auto: false },
  ];
  present.page.panels[0].crop = { x: 0.1, y: 0.2, width: 0.5, height: 0.4 };
  present.tray[0] = { ...present.tray[0], focus: { x: 0.5, y: 0.25 } };
  return document;
}

/**
 * Returns the records of a project without the fields that each save changes. A file that was opened adds its styles to the lists
 * of all projects.
 * @param {{ projects: Record<string, any>, states: Record<string, any> }} tables of one project
 */
export function essence({ projects, states, ...rest }) {
  const about = Object.values(projects).map(
    ({ changed: _changed, stamp: _stamp, picture: _picture, ...record }) => record,
  );
  const kept = Object.values(states).map(({ stamp: _stamp, bytes, ...record }) => ({
    ...record,
    history: unshared(historyIn({ bytes })),
  }));
  return { about, kept, ...rest };
}

/** Returns the history in a record of the table `states`, whose bytes are an object here. @param {any} record */
export function historyIn({ bytes }) {
  return expanded(recordIn(Uint8Array.from(Object.values(bytes))).history);
}

/** Returns a history without the lists that all projects share. @param {any} history */
export function unshared({ past, present, future, ...rest }) {
  const own = (/** @type {any} */ { mine: _mine, favourites: _favourites, ownLayouts: _layouts, ...project }) =>
    project;
  return { ...rest, past: past.map(own), present: own(present), future: future.map(own) };
}
