/**
 * Describes the page in text, from the detected subjects of its photos: for screen readers, and for alternative texts
 * elsewhere.
 */

import { strings } from '../strings/strings.ts';
import { roleOf } from '../document/word-names.ts';
import { grown } from './panels/merging.ts';
import type { Album } from '../document/album.ts';
import type { Bounds, PageDocument } from '../engine/types.ts';
import type { Seen } from '../strings/compose.ts';

/** a box in parts of its photo */
type Subject = Bounds & { label: string; score?: number };

/** Minimum detection score of a subject in a description. Less certain detections are often wrong. */
const SURE = 0.5;
/** The most kinds of things that are named. */
const MOST = 4;

/**
 * @param subjects of a photo
 * @param crop the part that is shown; null shows all
 * @returns people first, then what is largest
 */
export function seenIn(subjects: readonly Subject[], crop: Bounds | null): Seen[] {
  const shown = subjects.filter((subject) => (subject.score ?? 1) >= SURE && (crop === null || holds(crop, subject)));
  const of = (label: string) => shown.filter((subject) => subject.label === label);
  const area = (label: string) => of(label).reduce((sum, { width, height }) => sum + width * height, 0);
  // A detector may find the whole person, the face, or both.
  const people = Math.max(of('person').length, of('face').length);
  const kinds = [...new Set(shown.map(({ label }) => label))].filter((label) => label !== 'person' && label !== 'face');
  const things = kinds.sort((a, b) => area(b) - area(a)).map((label) => ({ label, count: of(label).length }));
  return [...(people > 0 ? [{ label: 'person', count: people }] : []), ...things].slice(0, MOST);
}

/** Whether the middle of a subject is in view. */
function holds(crop: Bounds, { x, y, width, height }: Bounds) {
  const [u, v] = [(x + width / 2 - crop.x) / crop.width, (y + height / 2 - crop.y) / crop.height];
  return u >= 0 && u <= 1 && v >= 0 && v <= 1;
}

/** @returns `two people and a dog`; empty without detected subjects */
export function describePanel(page: PageDocument, album: Album, panel: number): string {
  // Panels that are merged show one photo together.
  const { photo, crop } = page.panels[grown([panel], page)[0]];
  const subjects = (album.get(photo ?? '')?.meta?.subjects ?? []) as readonly Subject[];
  return strings.seen(seenIn(subjects, crop));
}

/**
 * @param style its name
 * @returns sentences that describe the page, as the `alt` text of an image
 */
export function describePage(page: PageDocument, album: Album, style: string): string {
  const panels = page.panels.map(({ photo }, i) =>
    strings.panelHolds({
      n: i + 1,
      what: photo === null ? strings.emptyPanel : describePanel(page, album, i) || strings.somePhoto,
    }),
  );
  const words = (page.words ?? []).map((word) =>
    strings.wordSays({ kind: strings.wordKind[roleOf(word)], text: word.text.replaceAll(/\s+/g, ' ').trim() }),
  );
  return [strings.pageAs({ panels: panels.length, style }), ...panels, ...words].join(' ');
}
