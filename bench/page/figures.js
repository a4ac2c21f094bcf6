// @ts-check
/** Extra time to draw a page if a subject breaks its panel border, on this thread. */

import initNets, { SubjectNet } from '/detector/inkpanel.js';
import { subjectOf } from './detect.js';
import init, { Album, Studio } from '/pkg/inkpanel.js';

/** Photos with a subject, and other photos that fill the page. */
const FIGURES = ['02-kitten', '07-red-panda', '08-kingfisher', '11-giraffe', '18-rocket', '19-astronaut'];
const OTHERS = ['01-coffee', '05-path', '06-castle', '09-mariachi', '12-pyramid', '17-festival'];
const PAGE = { width: 2480, height: 3508 };
const KEEP = { layout: false, style: false, photos: false };
/** Width in pixels of the rendered pages, as on a large screen. */
const WIDTH = 1600;
/** Number of seeds to try for pages on which a subject breaks its panel border, and number of pages to measure. */
const SEEDS = 40;
const PAGES = 7;
const RUNS = 5;

/**
 * @returns {Promise<{ pages: number, panels: number, plain: number, broken: number, ratio: number }>} medians over the
 * pages: number of panels, milliseconds without and with the breakout, and their ratio
 */
export async function figures() {
  await Promise.all([init(), initNets()]);
  const studio = new Studio();
  const net = new SubjectNet(await bytesOf('/models/subject.onnx'));
  const album = new Album();
  const metas = [];
  for (const id of [...FIGURES, ...OTHERS]) {
    const { meta, work } = JSON.parse(studio.import_photo(id, await bytesOf(`/album/${id}.jpg`)));
    const look = () => subjectOf(net, work.width, work.height, studio.photo_planes(`${id}/work`));
    metas.push(FIGURES.includes(id) ? { ...meta, mask: look() } : meta);
  }
  album.know(JSON.stringify(metas));
  const ids = JSON.stringify(metas.map(({ id }) => id));
  const ask = { photos: [], page: PAGE, current: null, keep: KEEP, mode: 'shuffle', style: 'comic', figures: true };
  const rows = [];
  for (let seed = 0; seed < SEEDS && rows.length < PAGES; seed += 1) {
    const broken = JSON.parse(album.plan(JSON.stringify({ ...ask, seed }), ids));
    const panels = broken.panels.map((/** @type {any} */ { figure, ...panel }) => panel);
    if (!broken.panels.some((/** @type {any} */ { figure }) => figure)) continue;
    const times = compared(studio, JSON.stringify({ ...broken, panels }), JSON.stringify(broken));
    rows.push({ panels: panels.length, ...times });
  }
  const median = (/** @type {number[]} */ list) => list.sort((a, b) => a - b)[list.length >> 1];
  const of = (/** @type {'panels' | 'plain' | 'broken'} */ key) => median(rows.map((row) => row[key]));
  const ratio = median(rows.map(({ plain, broken }) => broken / plain));
  return { pages: rows.length, panels: of('panels'), plain: of('plain'), broken: of('broken'), ratio };
}

/**
 * Measures both variants alternately, so that other load affects both. @param {Studio} studio @param {string} plain
 * @param {string} broken
 */
function compared(studio, plain, broken) {
  const times = { plain: /** @type {number[]} */ ([]), broken: /** @type {number[]} */ ([]) };
  const draw = (/** @type {string} */ document) => {
    const start = performance.now();
    studio.compose(document, WIDTH, 'work').free();
    return performance.now() - start;
  };
  draw(plain);
  for (let run = 0; run < RUNS; run += 1) {
    times.plain.push(draw(plain));
    times.broken.push(draw(broken));
  }
  const least = (/** @type {number[]} */ list) => Math.min(...list);
  return { plain: least(times.plain), broken: least(times.broken) };
}

/** @param {string} address */
async function bytesOf(address) {
  return new Uint8Array(await (await fetch(address)).arrayBuffer());
}
