// @ts-check
/**
 * Times one contestant. The `load` function of its module receives the picture and returns functions by row id. Each
 * function runs the operation once on pixels that the contestant already holds. So copying is not timed, if the
 * interface allows that.
 */

/** @typedef {{ width: number, height: number, data: Uint8ClampedArray }} Picture RGBA */
/**
 * @typedef {{
 *   id: string, label: string, luma: boolean, planes: number, done: number | null, style: object,
 *   params: Record<string, any>,
 * }} Row
 * The first word of `id` names the operation. `luma`: runs on a gray picture. `planes`: mean number of planes that it
 * reads and writes. `style`: the style for Inkpanel. Blocks before index `done` are not timed. `params`: parameters of the
 * block, for other libraries.
 */
/**
 * @typedef {(() => void) | { prepare: () => any, run: (prepared: any) => void }} Operation
 * With `prepare` untimed, for libraries that change an image in place.
 */
/** @typedef {(picture: Picture) => Promise<(row: Row) => Operation | undefined>} Load */

const RUNS = 15;
const WARM = 3;
/** Maximum milliseconds of a row with more than the least number of runs. Slow operations vary little. */
const PATIENCE = 1500;
const LEAST_RUNS = 3;

/**
 * @param {string} name of a file in `contestants`
 * @param {Row[]} rows
 * @param {Picture} picture
 * @returns {Promise<Record<string, number>>} median milliseconds by row id; rows it cannot do are absent
 */
export async function contest(name, rows, picture) {
  /** @type {{ load: Load }} */
  const { load } = await import(`./contestants/${name}.js`);
  const find = await load(picture);
  /** @type {Record<string, number>} */
  const times = {};
  for (const row of rows) {
    try {
      const operation = find(row);
      if (operation) times[row.id] = median(operation);
    } catch (error) {
      // OpenCV throws bare numbers.
      throw new Error(`${row.id}: ${error instanceof Error ? error.message : error}`);
    }
  }
  return times;
}

/** @param {Operation} operation */
function median(operation) {
  const { prepare, run } = typeof operation === 'function' ? { prepare: () => {}, run: operation } : operation;
  /** @type {number[]} */
  const times = [];
  const begin = performance.now();
  const tired = () => performance.now() - begin > PATIENCE;
  for (let warm = 0; warm < WARM && !tired(); warm += 1) run(prepare());
  while (times.length < RUNS && !(times.length >= LEAST_RUNS && tired())) {
    const prepared = prepare();
    const start = performance.now();
    run(prepared);
    times.push(performance.now() - start);
  }
  return times.sort((a, b) => a - b)[times.length >> 1];
}
