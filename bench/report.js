// @ts-check
/** The results as a Markdown table, and that table's place in the README. */

import { readFileSync, writeFileSync } from 'node:fs';

import { REST } from './journey.js';

/** @typedef {import('./page/contest.js').Row} Row */
/**
 * @typedef {{
 *   machine: { cores: number, cpu: string, browser: string, copySpeed: number },
 *   rows: Row[], times: Record<string, Record<string, number>>, failed: Record<string, string>,
 *   versions: Record<string, string>, journey: { firstPage: number, drawn: number, decoded: number, refined: number, closer: number, shuffle: number, rested: number, hurried: { count: number, ms: number }, png: number, thumbnails: number, listed: number } | null,
 *   plans: { count: number, ms: number, first: number }[] | null,
 *   facts: number | null,
 *   masks: { layout: string, ms: number } | null, detect: { faces: number, objects: number, load: number, subject: number } | null,
 *   figures: { pages: number, panels: number, plain: number, broken: number, ratio: number } | null,
 *   aesthetics: { ms: number, load: number } | null,
 *   crowd: Awaited<ReturnType<typeof import('./crowd.js').crowd>> | null,
 *   footage: ({ minutes: number } & Awaited<ReturnType<typeof import('./crowd.js').crowd>>)[] | null,
 *   masking: Awaited<ReturnType<typeof import('./masking.js').masking>> | null,
 *   making: Awaited<ReturnType<typeof import('./making.js').making>> | null,
 *   films: import('./animatic.js').Film[] | null,
 *   loops: import('./living.js').Loop[] | null,
 * }} Results `times` are milliseconds by contestant and row
 */

const PEERS = { opencv: 'OpenCV.js', canvas: 'canvas 2D', vips: 'wasm-vips', photon: 'photon' };
const PIXELS = 1920 * 1080;

/** @param {Results} results */
export function markdown({
  machine,
  rows,
  times,
  failed,
  versions,
  journey,
  facts,
  plans,
  masks,
  detect,
  aesthetics,
  crowd,
  footage,
  making,
  masking,
  figures,
  films,
  loops,
}) {
  const peers = Object.entries(PEERS);
  const heads = peers.map(([id, name]) => (versions[id] ? `${name} ${versions[id]}` : name));
  const lines = [
    `Milliseconds at 1920x1080 on one thread of ${machine.cpu} (${machine.cores} cores), ${machine.browser}, medians.`,
    "A peer's column has its time and how many times longer it takes; wasm-vips uses all cores. *Of copy* is the time",
    `to copy the same bytes at the measured ${(machine.copySpeed / 1e9).toFixed(1)} GB/s, as a share of the block's.`,
    '',
    `| Block | ms | of copy | ${heads.join(' | ')} |`,
    `|---|--:|--:|${'--:|'.repeat(heads.length)}`,
  ];
  for (const row of rows) {
    const own = times.inkpanel?.[row.id];
    if (own === undefined) continue;
    const share = copyTime(row, machine.copySpeed) / own;
    const cells = peers.map(([id]) => {
      const peer = times[id]?.[row.id];
      return failed[id] ? 'failed' : peer === undefined ? '' : `${short(peer)} (${short(peer / own)}x)`;
    });
    lines.push(`| ${row.label} | ${short(own)} | ${Math.round(share * 100)} % | ${cells.join(' | ')} |`);
  }
  for (const [id, reason] of Object.entries(failed)) lines.push('', `${PEERS[id] ?? id} failed: ${reason}`);
  if (
    journey ||
    facts ||
    plans ||
    masks ||
    detect ||
    aesthetics ||
    crowd ||
    footage ||
    making ||
    masking ||
    figures ||
    films ||
    loops
  )
    lines.push('', '| In the page, all workers | |', '|---|--:|');
  if (journey) {
    lines.push(
      `| Twelve 12-megapixel JPEG files to the first page on the screen | ${(journey.drawn / 1000).toFixed(2)} s |`,
      `| The same files decoded by the browser itself, \`createImageBitmap\` | ${(journey.decoded / 1000).toFixed(2)} s |`,
      `| The same files until all are read and the page stands | ${(journey.firstPage / 1000).toFixed(2)} s |`,
      `| From the first page until its twelve photos are searched for faces and objects | ${(journey.refined / 1000).toFixed(2)} s |`,
      `| The same, until small faces were looked for in parts of them, too | ${(journey.closer / 1000).toFixed(2)} s |`,
      `| Shuffle to visible page, one after the other | ${Math.round(journey.shuffle)} ms |`,
      `| The same after ${REST / 1000} s of rest | ${Math.round(journey.rested)} ms |`,
      `| The same in the ten seconds after the first page, the slowest but one in twenty of ${journey.hurried.count} | ${Math.round(journey.hurried.ms)} ms |`,
      `| PNG of 2480 x 3508 from the original photos | ${(journey.png / 1000).toFixed(2)} s |`,
      `| The ${journey.listed} thumbnails of the layouts, for another page size | ${Math.round(journey.thumbnails)} ms |`,
    );
  }
  if (facts)
    lines.push(
      `| What framing has to know of a photo: tones, edges, colours, lettering, one thread | ${short(facts)} ms |`,
    );
  for (const { count, ms, first } of plans ?? [])
    lines.push(
      `| A page planned from ${count} photos, one thread (and once for each photo that is new) | ${short(ms)} ms (${short(first)} ms) |`,
    );
  if (masks)
    lines.push(`| Masks and borders of a page at 2480 x 3508, slowest layout, one thread | ${short(masks.ms)} ms |`);
  if (detect) {
    lines.push(
      `| Faces of a photo, one worker | ${short(detect.faces)} ms |`,
      `| Objects of a photo, one worker | ${short(detect.objects)} ms |`,
      `| The detectors made ready, once | ${Math.round(detect.load)} ms |`,
      `| Subject of a photo, one worker (times as long as its objects) | ${short(detect.subject)} ms (${short(detect.subject / detect.objects)}x) |`,
    );
  }
  if (figures) {
    const { pages, panels, plain, broken, ratio } = figures;
    lines.push(
      `| A page of 1600 pixels across and ${panels} panels with a figure that steps out, and without, ${pages} pages, one thread | ${short(broken)} ms, ${short(plain)} ms (${short(ratio)}x) |`,
    );
  }
  if (masking) {
    const { count, during, after, first, bare } = masking;
    lines.push(
      `| Shuffle to visible page while masks are made (${count}), and once they are there | ${Math.round(during)} ms, ${Math.round(after)} ms |`,
      `| Twelve photos to the first page with the net of subjects on the site, and without | ${(first / 1000).toFixed(2)} s, ${(bare / 1000).toFixed(2)} s |`,
    );
  }
  if (aesthetics) {
    lines.push(
      `| How good a picture looks, by NIMA, one worker | ${short(aesthetics.ms)} ms |`,
      `| NIMA made ready, once | ${Math.round(aesthetics.load)} ms |`,
    );
  }
  if (crowd) {
    const { photos, first, read, found, longest, long, memory } = crowd;
    lines.push(
      `| An album of ${photos} photos of twelve megapixels, its first page | ${(first / 1000).toFixed(2)} s |`,
      `| The same, all read and the page drawn | ${(read / 1000).toFixed(1)} s |`,
      `| The same, all searched for faces and objects | ${(found / 1000).toFixed(1)} s |`,
      `| The same, longest task of the page's main thread (and tasks above 50 ms) | ${Math.round(longest)} ms (${long}) |`,
      ...peakOf(memory),
    );
  }
  for (const { minutes, first, read, memory } of footage ?? [])
    lines.push(
      `| A film of ${minutes} minutes at 854 x 480: its first page, all its frames | ${(first / 1000).toFixed(2)} s, ${(read / 1000).toFixed(1)} s |`,
      ...peakOf(memory),
    );
  if (making) {
    const { frames, width, height, styles, searches, hasty } = making;
    const seconds = (/** @type {number} */ ms) => (ms / 1000).toFixed(1);
    const searched = searches.map(seconds).join(', ');
    lines.push(
      `| Designer: preview of ${width} x ${height} while a slider of a three-block chain moves, one worker | ${Math.round(frames)} pictures/s |`,
      `| Explorer: styles invented, drawn as thumbnails, scored and compared | ${Math.round(styles)} a second |`,
      `| A style from a picture, three pictures: from the file, four seconds after the workspace was opened, to all proposals | ${searched} s |`,
      `| The same where the file comes with the workspace | ${seconds(hasty)} s |`,
    );
  }
  for (const { kind, frames, ms, bytes } of films ?? [])
    lines.push(
      `| An animatic of twelve shots at 1080p as ${kind.toUpperCase()}, from the click to the file of ${Math.round(bytes / 1e6)} MB | ${((frames / ms) * 1000).toFixed(1)} frames/s |`,
    );
  for (const { style, pictures, ms, width, height } of loops ?? [])
    lines.push(
      `| A panel that moves, about ${width} x ${height}, ${style}: frames decoded and drawn, one worker | ${((pictures / ms) * 1000).toFixed(1)} pictures/s |`,
    );
  return lines.join('\n');
}

/** @param {number | null} memory bytes; null where the system does not tell */
function peakOf(memory) {
  return memory ? [`| The same, peak memory of the tab's process | ${(memory / 2 ** 30).toFixed(2)} GB |`] : [];
}

/** Milliseconds to copy what a row reads and writes. @param {Row} row @param {number} speed bytes a second */
function copyTime({ planes }, speed) {
  return ((PIXELS * planes) / speed) * 1000;
}

/** Three digits at most. @param {number} value */
function short(value) {
  return value >= 100 ? value.toFixed(0) : value >= 10 ? value.toFixed(1) : value.toFixed(2);
}

/**
 * Puts the table between the README's markers.
 * @param {string} path
 * @param {string} table
 */
export function insert(path, table) {
  const text = readFileSync(path, 'utf8');
  const [start, end] = ['<!-- bench:start -->', '<!-- bench:end -->'];
  const [from, to] = [text.indexOf(start), text.indexOf(end)];
  if (from < 0 || to < from) throw new Error(`${path} lacks the markers ${start} and ${end}`);
  writeFileSync(path, `${text.slice(0, from + start.length)}\n${table}\n${text.slice(to)}`);
}
