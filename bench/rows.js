// @ts-check
/** Rows of the benchmark: every block, variants with a different cost, and whole styles. */

/** @typedef {import('./page/contest.js').Row} Row */

/** Parameters of blocks that do nothing by default. @type {Record<string, Record<string, any>>} */
const TELLING = { hue: { angle: 30 }, size: { percent: 50 }, dynamic_range: { range: 255 } };

/** Blocks that accept both and are usually used with colour. */
const COLOURFUL = ['to_gray', 'to_color', 'halftone', 'kuwahara', 'strokes', 'flatten', 'plates', 'paper'];

/** More of the same blocks. @type {[block: string, luma: boolean, params: Record<string, any>][]} */
const VARIANTS = [
  ['posterize', false, {}],
  // As the peers do it.
  ['brightness', false, { channels: 'each' }],
  ['gaussian', true, { sigma: 6 }],
  ['gaussian', false, { sigma: 6 }],
  ['size', false, { percent: 50 }],
  ['size', true, { percent: 200 }],
  ['size', false, { percent: 200 }],
];

/** A plain comic: smooth areas in few tones below ink lines. */
const COMIC = {
  id: 'comic-row',
  name: 'Comic',
  background: [
    { block: 'detail', delta: -100 },
    { block: 'posterize', levels: 8 },
  ],
  foreground: [{ block: 'to_gray' }, { block: 'xdog' }, { block: 'soft_threshold' }],
};

/**
 * @param {any[]} blocks descriptors
 * @param {any[]} styles style files
 * @returns {Row[]}
 */
export function rows(blocks, styles) {
  const found = new Map(blocks.map((block) => [block.id, block]));
  const list = blocks.map((block) =>
    blockRow(block, block.input !== 'color' && !COLOURFUL.includes(block.id), TELLING[block.id] ?? {}),
  );
  for (const [id, luma, params] of VARIANTS) {
    const block = found.get(id);
    if (block && (block.input === 'any' || luma === (block.input === 'luma'))) list.push(blockRow(block, luma, params));
  }
  // The other row with To Color also computes U and V, which the chain stored here. No peer has a name for half of it.
  const alone = { id: 'row', name: 'Row', background: [{ block: 'to_gray' }, { block: 'to_color' }] };
  list.push({
    id: 'alone to_color',
    label: 'To Color',
    luma: false,
    planes: 3,
    done: 1,
    style: alone,
    params: {},
  });
  list.push({
    id: 'comic',
    label: 'Comic: smoothed, 8 levels, ink',
    luma: false,
    planes: 3,
    done: null,
    style: COMIC,
    params: {},
  });
  for (const style of styles.filter(({ id }) => id.startsWith('paper-'))) {
    list.push({ id: style.id, label: `Style ${style.name}`, luma: false, planes: 3, done: null, style, params: {} });
  }
  return [...new Map(list.map((row) => [row.id, row])).values()];
}

/**
 * @param {any} block
 * @param {boolean} luma
 * @param {Record<string, any>} params
 * @returns {Row}
 */
function blockRow(block, luma, params) {
  const defaults = Object.fromEntries(block.params.map((/** @type {any} */ p) => [p.id, p.default]));
  const told = Object.entries(params).map(([name, value]) => `${name} ${value}`);
  const planes = (/** @type {string} */ channels) => (channels === 'luma' || (channels === 'any' && luma) ? 1 : 3);
  // To Color without To GrayScale has no colours to restore.
  const gray = luma || block.id === 'to_color' ? [{ block: 'to_gray' }] : [];
  const words = [...told, luma ? 'luma' : 'colour'];
  return {
    id: [block.id, ...words].join(' '),
    label: `${block.id === 'to_color' ? 'To GrayScale, ' : ''}${block.label}${told.length ? `, ${told.join(', ')}` : ''}${luma ? '' : ', colour'}`,
    luma,
    planes: (planes(block.input) + planes(block.output)) / 2,
    done: luma ? 1 : 0,
    style: { id: 'row', name: 'Row', background: [...gray, { block: block.id, ...params }] },
    params: { ...defaults, ...params },
  };
}
