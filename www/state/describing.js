// @ts-check
/** The page in words, from what was found in its photos: for who does not see it, here and wherever it is shown. */

import { strings } from '../strings.js';
import { grown } from './merging.js';

/** @typedef {import('../engine/documents.js').PageDocument} PageDocument */
/** @typedef {import('../engine/documents.js').Bounds} Bounds */
/** @typedef {import('../strings/en/describing.js').Seen} Seen */
/** @typedef {Bounds & { label: string, score?: number }} Subject a box in parts of its photo */

/** What the net is less sure of is often something else. */
const SURE = 0.5;
/** The most kinds of things that are named. */
const MOST = 4;

/**
 * @param {readonly Subject[]} subjects of a photo
 * @param {Bounds | null} crop the part that is shown; null shows all
 * @returns {Seen[]} people first, then what is largest
 */
export function seenIn(subjects, crop) {
  const shown = subjects.filter((subject) => (subject.score ?? 1) >= SURE && (crop === null || holds(crop, subject)));
  const of = (/** @type {string} */ label) => shown.filter((subject) => subject.label === label);
  const area = (/** @type {string} */ label) => of(label).reduce((sum, { width, height }) => sum + width * height, 0);
  // A person is found as a whole, by the face, or by both.
  const people = Math.max(of('person').length, of('face').length);
  const kinds = [...new Set(shown.map(({ label }) => label))].filter((label) => label !== 'person' && label !== 'face');
  const things = kinds.sort((a, b) => area(b) - area(a)).map((label) => ({ label, count: of(label).length }));
  return [...(people > 0 ? [{ label: 'person', count: people }] : []), ...things].slice(0, MOST);
}

/** Whether the middle of a subject is in view. @param {Bounds} crop @param {Bounds} subject */
function holds(crop, { x, y, width, height }) {
  const [u, v] = [(x + width / 2 - crop.x) / crop.width, (y + height / 2 - crop.y) / crop.height];
  return u >= 0 && u <= 1 && v >= 0 && v <= 1;
}

/**
 * @param {PageDocument} page
 * @param {import('./album.js').Album} album
 * @param {number} panel
 * @returns {string} `two people and a dog`; empty where nothing was found
 */
export function describePanel(page, album, panel) {
  // Panels that are merged show one photo together.
  const { photo, crop } = page.panels[grown([panel], page)[0]];
  const subjects = /** @type {readonly Subject[]} */ (album.get(photo ?? '')?.meta?.subjects ?? []);
  return strings.seen(seenIn(subjects, crop));
}

/**
 * @param {PageDocument} page
 * @param {import('./album.js').Album} album
 * @param {string} style its name
 * @returns {string} sentences that stand for the page, as the `alt` of an image does
 */
export function describePage(page, album, style) {
  const panels = page.panels.map(({ photo }, i) => (
    strings.panelHolds(i + 1, photo === null ? strings.emptyPanel : describePanel(page, album, i) || strings.somePhoto)
  ));
  const words = (page.words ?? []).map(({ kind, text }) => strings.wordSays(strings.wordKind[kind], text.replaceAll(/\s+/g, ' ').trim()));
  return [strings.pageAs(panels.length, style), ...panels, ...words].join(' ');
}
