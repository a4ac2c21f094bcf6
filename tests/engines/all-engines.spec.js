// @ts-check
/** One project gives the same files in every browser. */

import { createHash } from 'node:crypto';
import { start } from './engines.js';
import { PNG, SIX, expect, personIn, given, plain } from './hands.js';

const hash = (/** @type {Uint8Array} */ bytes) => createHash('sha256').update(bytes).digest('hex');

plain('one project gives the same pixels and the same PDF in Chromium, Firefox and WebKit', async ({ baseURL }) => {
  const address = String(baseURL);
  const maker = await start('chromium');
  /** @type {Record<string, { png: string, pdf: string }>} */
  const files = {};
  const drawn = async (/** @type {string} */ engine, /** @type {import('./hands.js').Person} */ person) => {
    const { width, height, data } = PNG.sync.read((await person.savedAs('png')).bytes);
    const pdf = await person.savedAs('pdf');
    files[engine] = { png: `${width} x ${height} ${hash(data)}`, pdf: hash(pdf.bytes) };
  };
  try {
    const person = await personIn(maker, address);
    await person.begin([...SIX, given('oracles/data/foreign/plain.avif')]);
    await person.tab('Layouts');
    await person.select('Panels', '6');
    await person.idle();
    await person.press('Shuffle');
    await person.say('THE SAME');
    const project = await person.savedProject();
    for (const engine of ['chromium', 'firefox', 'webkit']) {
      const running = await start(engine);
      try {
        const other = await personIn(running, address);
        await other.begin([project.path]);
        await other.one('button', /^Balloon: THE SAME/);
        await drawn(engine, other);
      } finally {
        await running.end();
      }
    }
  } finally {
    await maker.end();
  }
  expect(files.firefox).toEqual(files.chromium);
  expect(files.webkit).toEqual(files.chromium);
});
