// @ts-check
/** Writes the results as Markdown: a table for docs/reports/benchmarks.md, and the main numbers for README.md. */

import { readFileSync, writeFileSync } from 'node:fs';

import { REST } from './journey.js';

/** @typedef {import('./page/contest.js').Row} Row */
/**
 * @typedef {{
 *   machine: { cores: number, cpu: string, browser: string, copySpeed: number, load: number },
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
    `Median milliseconds at 1920 x 1080, one thread of ${machine.cpu} (${machine.cores} cores), ${machine.browser}. Load average at the start: ${machine.load.toFixed(2)}.`,
    'Columns of other libraries show their time and the ratio to Inkpanel. wasm-vips uses all cores.',
    `The column *of copy* is the time to copy the same bytes at the measured ${(machine.copySpeed / 1e9).toFixed(1)} GB/s, divided by the time of the block.`,
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
    lines.push('', '| In the app, all workers | |', '|---|--:|');
  if (journey) {
    lines.push(
      `| First page from twelve 12-megapixel JPEG files | ${(journey.drawn / 1000).toFixed(2)} s |`,
      `| Browser decode of these files, \`createImageBitmap\` | ${(journey.decoded / 1000).toFixed(2)} s |`,
      `| All twelve files read and the page complete | ${(journey.firstPage / 1000).toFixed(2)} s |`,
      `| Face and object detection in twelve photos, after the first page | ${(journey.refined / 1000).toFixed(2)} s |`,
      `| Detection including small faces in photo quarters | ${(journey.closer / 1000).toFixed(2)} s |`,
      `| Shuffle to visible page, repeated without pause | ${Math.round(journey.shuffle)} ms |`,
      `| Shuffle to visible page after ${REST / 1000} s of rest | ${Math.round(journey.rested)} ms |`,
      `| Shuffle in the first ten seconds, 95th percentile of ${journey.hurried.count} | ${Math.round(journey.hurried.ms)} ms |`,
      `| PNG export at 2480 x 3508 from the original photos | ${(journey.png / 1000).toFixed(2)} s |`,
      `| Thumbnails of ${journey.listed} layouts after a change of the page size | ${Math.round(journey.thumbnails)} ms |`,
    );
  }
  if (facts)
    lines.push(`| Photo analysis for cropping (tones, edges, colours, lettering), one thread | ${short(facts)} ms |`);
  for (const { count, ms, first } of plans ?? [])
    lines.push(
      `| Planning a page from ${count} photos, one thread (plus once per new photo) | ${short(ms)} ms (${short(first)} ms) |`,
    );
  if (masks)
    lines.push(`| Panel masks and borders at 2480 x 3508, slowest layout, one thread | ${short(masks.ms)} ms |`);
  if (detect) {
    lines.push(
      `| Face detection in a photo, one worker | ${short(detect.faces)} ms |`,
      `| Object detection in a photo, one worker | ${short(detect.objects)} ms |`,
      `| Loading the detectors, once | ${Math.round(detect.load)} ms |`,
      `| Subject mask of a photo, one worker (relative to object detection) | ${short(detect.subject)} ms (${short(detect.subject / detect.objects)}x) |`,
    );
  }
  if (figures) {
    const { pages, panels, plain, broken, ratio } = figures;
    lines.push(
      `| Page 1600 pixels wide with ${panels} panels, with and without a subject that breaks its panel, ${pages} pages, one thread | ${short(broken)} ms, ${short(plain)} ms (${short(ratio)}x) |`,
    );
  }
  if (masking) {
    const { count, during, after, first, bare } = masking;
    lines.push(
      `| Shuffle to visible page during and after subject detection (${count} shuffles) | ${Math.round(during)} ms, ${Math.round(after)} ms |`,
      `| First page with and without the subject model on the site | ${(first / 1000).toFixed(2)} s, ${(bare / 1000).toFixed(2)} s |`,
    );
  }
  if (aesthetics) {
    lines.push(
      `| Aesthetic score (NIMA) of a picture, one worker | ${short(aesthetics.ms)} ms |`,
      `| Loading NIMA, once | ${Math.round(aesthetics.load)} ms |`,
    );
  }
  if (crowd) {
    const { photos, first, read, longest, long, memory } = crowd;
    lines.push(
      `| ${photos} photos of twelve megapixels: first page | ${(first / 1000).toFixed(2)} s |`,
      `| ${photos} photos: all read and the page drawn | ${(read / 1000).toFixed(1)} s |`,
      `| ${photos} photos: longest main-thread task (number of tasks above 50 ms) | ${Math.round(longest)} ms (${long}) |`,
      ...peakOf(`${photos} photos`, memory),
    );
  }
  for (const { minutes, first, read, memory } of footage ?? [])
    lines.push(
      `| Video of ${minutes} minutes at 854 x 480: first page, all frames | ${(first / 1000).toFixed(2)} s, ${(read / 1000).toFixed(1)} s |`,
      ...peakOf(`Video of ${minutes} minutes`, memory),
    );
  if (making) {
    const { frames, width, height, styles, searches, hasty } = making;
    const seconds = (/** @type {number} */ ms) => (ms / 1000).toFixed(1);
    const searched = searches.map(seconds).join(', ');
    lines.push(
      `| Designer preview at ${width} x ${height} while dragging a slider (three blocks), one worker | ${Math.round(frames)} frames/s |`,
      `| Explorer: styles generated, drawn, scored and compared | ${Math.round(styles)} per second |`,
      `| Style from a picture, all proposals of three pictures, four seconds after opening the workspace | ${searched} s |`,
      `| Style from a picture, with the file at once | ${seconds(hasty)} s |`,
    );
  }
  for (const { kind, frames, ms, bytes } of films ?? [])
    lines.push(
      `| Animatic of twelve shots at 1080p as ${kind.toUpperCase()}, file of ${Math.round(bytes / 1e6)} MB | ${((frames / ms) * 1000).toFixed(1)} frames/s |`,
    );
  for (const { style, pictures, ms, width, height } of loops ?? [])
    lines.push(
      `| Animated panel, about ${width} x ${height}, ${style}: frames decoded and drawn, one worker | ${((pictures / ms) * 1000).toFixed(1)} frames/s |`,
    );
  return lines.join('\n');
}

/**
 * @param {string} name
 * @param {number | null} memory in bytes; null if the system does not report it
 */
function peakOf(name, memory) {
  return memory ? [`| ${name}: peak memory of the tab process | ${(memory / 2 ** 30).toFixed(2)} GB |`] : [];
}

/**
 * Milliseconds to copy the data that a row reads and writes. @param {Row} row @param {number} speed bytes per second
 */
function copyTime({ planes }, speed) {
  return ((PIXELS * planes) / speed) * 1000;
}

/** Three digits at most. @param {number} value */
function short(value) {
  return value >= 100 ? value.toFixed(0) : value >= 10 ? value.toFixed(1) : value.toFixed(2);
}

/**
 * Returns the numbers of the README; empty if the page was not timed.
 * @param {Results} results
 */
export function highlights({ machine, journey }) {
  if (!journey) return '';
  const seconds = (/** @type {number} */ ms) => (ms / 1000).toFixed(1);
  return [
    `Medians in Chromium on ${machine.cores} cores of ${machine.cpu}:`,
    '',
    `- ${seconds(journey.drawn)} seconds from twelve 12-megapixel photos to the first page.`,
    `- ${Math.round(journey.rested)} milliseconds from Shuffle to the next page.`,
    `- ${seconds(journey.png)} seconds for an A4 page at 300 DPI as PNG.`,
  ].join('\n');
}

/**
 * Replaces the text between the markers `bench:start` and `bench:end`.
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
