// @ts-check
/** This project's core, built with the feature `bench`: blocks and styles on planes in its memory. */

import init, { Bench, blocks, styles } from '/pkg/inkpanel.js';

const PAINTERS = '/models/painters.onnx';

/** @type {import('../contest.js').Load} */
export async function load({ width, height, data }) {
  await init();
  const rgba = new Uint8Array(data);
  const painters = new Uint8Array(await (await fetch(PAINTERS)).arrayBuffer());
  /** @type {Bench | undefined} */
  let bench;
  return ({ style, done }) => {
    bench?.free();
    const current = (bench = new Bench(JSON.stringify(style), done ?? 0, width, height, rgba));
    if (JSON.stringify(style).includes('"painter"')) current.know_painters(painters);
    return done === null ? () => current.run_style() : { prepare: () => current.prepare(), run: () => current.run() };
  };
}

/** @returns {Promise<{ blocks: any[], styles: any[] }>} the rows to measure */
export async function catalogue() {
  await init();
  return { blocks: JSON.parse(blocks()), styles: JSON.parse(styles()) };
}
